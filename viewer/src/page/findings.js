// Findings of rooms: their letters, their words and their order.
import { words } from './text.js';

/** Failed ones first. Letters and shapes tell severities apart where colours cannot. */
const SEVERITIES = [
  { severity: 'failed', letter: 'F', shape: 'square', name: 'Failed' },
  { severity: 'minor', letter: 'm', shape: 'circle', name: 'Minor' },
];

const EXPLANATIONS = {
  collision: 'two bodies intersect', out_of_room: 'part of a body lies outside the room', floating: 'does not touch its support',
  unsupported: 'hangs over the edge of its support', door_blocked: 'stands in the swing or approach of a door',
  unreachable: 'people cannot walk there', blocked_use: 'the space needed before a side is taken',
  tight_use: 'little space before a side', window_blocked: 'stands before a window', tv_position: 'a screen that nobody sees well',
  facing: 'faces the wrong way', wet_room: 'a fixture right before the toilet', bedside: 'one side only to get into the bed',
  crowded_half: 'nearly all furniture is in one half of the room', crooked: 'not parallel to its wall',
  missing_required: 'a required piece is absent', unfulfilled: 'too few of the requested pieces have a place',
  sparse: 'less furniture than the style asks for', bare: 'surfaces are empty', narrow_way: 'a way too narrow for a wheelchair',
  no_turning_circle: 'no room to turn a wheelchair',
};

export const severityOf = ({ severity }) => SEVERITIES.find((each) => each.severity === severity) ?? SEVERITIES[1];

/** All findings of rooms {id, extras}, the severe ones first: {room, code, objects, severity, ...}. */
export function findingsOf(rooms) {
  const all = rooms.flatMap(({ id, extras }) => (extras.findings ?? []).map((finding) => ({ ...finding, room: id, objects: finding.objects ?? [] })));
  const rank = (finding) => SEVERITIES.indexOf(severityOf(finding));
  return all.sort((a, b) => rank(a) - rank(b));
}

/** One line: "Crowded half: row_basin.1. Nearly all ...; 0.89, threshold 0.85". */
export function findingText({ code, objects, measured, threshold, given }) {
  const about = objects.length > 0 ? ` (${objects.join(', ')})` : '';
  const explanation = EXPLANATIONS[code] ? `: ${EXPLANATIONS[code]}` : '';
  const figures = typeof measured === 'number'
    ? `. Measured ${measured.toFixed(2)}${typeof threshold === 'number' ? `, threshold ${threshold.toFixed(2)}` : ''}` : '';
  return `${words(code)}${explanation}${about}${figures}${given ? ', which the plan makes unavoidable' : ''}`;
}
