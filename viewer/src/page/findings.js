// Findings of rooms: their letters, their words and their order.
import { words } from './text.js';

/** Failed ones first. Letters and shapes tell severities apart where colours cannot. */
const SEVERITIES = [
  { severity: 'failed', letter: 'F', shape: 'square', name: 'Failed' },
  { severity: 'minor', letter: 'm', shape: 'circle', name: 'Minor' },
];

export const severityOf = ({ severity }) => SEVERITIES.find((each) => each.severity === severity) ?? SEVERITIES[1];

/** All findings of rooms {id, extras}, the severe ones first: {room, code, objects, severity, ...}. */
export function findingsOf(rooms) {
  const all = rooms.flatMap(({ id, extras }) => (extras.findings ?? []).map((finding) => ({ ...finding, room: id, objects: finding.objects ?? [] })));
  const rank = (finding) => SEVERITIES.indexOf(severityOf(finding));
  return all.sort((a, b) => rank(a) - rank(b));
}

/**
 * One line: "Crowded half: nearly all furniture in one half of the room (basin.1). Measured 0.89, threshold 0.85". `meanings` is that of
 * the site: a sentence for each code.
 */
export function findingText({ code, objects, measured, threshold, given }, meanings) {
  const about = objects.length > 0 ? ` (${objects.join(', ')})` : '';
  const figures = typeof measured === 'number'
    ? `. Measured ${measured.toFixed(2)}${typeof threshold === 'number' ? `, threshold ${threshold.toFixed(2)}` : ''}` : '';
  return `${words(code)}${explanation(meanings[code])}${about}${figures}${given ? ', which the plan makes unavoidable' : ''}`;
}

/** A sentence as the end of another; nothing for a code that the server does not know. */
function explanation(meaning) {
  if (!meaning) return '';
  return `: ${meaning.charAt(0).toLowerCase()}${meaning.slice(1).replace(/\.$/, '').replaceAll('`', '')}`;
}
