// Why a piece is where it is, in lines of text from the answer of api/explain.
import { metres, words } from './text.js';

/** More obstacles than this tell nothing new. */
const MOST_OBSTACLES = 3;

/** Sections {title, lines} about a piece; none if the explanation does not know it. */
export function reasonOf(explanation, id) {
  const piece = explanation.objects?.find((object) => object.id === id);
  if (!piece) return [];
  const search = piece.search ?? {};
  return [
    { title: 'Wishes', lines: (piece.wishes ?? []).map(wishText) },
    { title: 'Search', lines: [searchText(search), ...(search.refused ?? []).map(refusalText)].filter(Boolean) },
    { title: 'Afterwards', lines: (explanation.edited_afterwards ?? []).includes(id) ? ['Moved or turned by an edit'] : [] },
  ].filter(({ lines }) => lines.length > 0);
}

/** Lines about the pieces that a room lacks. */
export function missingOf(explanation) {
  const isRequired = (piece) => piece.is_required ?? piece.required;
  return (explanation.missing ?? []).map((piece) => `${words(piece.class)}: ${piece.reason}${isRequired(piece) ? ', required' : ''}`);
}

function wishText({ about, target, is_met: isMet, decided_by: decidedBy, distance, points, weight }) {
  const subject = decidedBy && decidedBy !== target ? `${words(target).toLowerCase()} (${decidedBy})` : words(target ?? '').toLowerCase();
  const far = typeof distance === 'number' ? `, ${metres(distance)}` : '';
  const share = typeof points === 'number' && typeof weight === 'number' ? `; ${points.toFixed(1)} of ${weight.toFixed(1)} points` : '';
  return `${isMet ? 'Met' : 'Not met'}: ${about} ${subject}${far}${share}`;
}

function searchText({ places, refused = [], was_pushed: wasPushed, was_sent_away: wasSentAway }) {
  if (typeof places !== 'number') return null;
  const count = refused.reduce((sum, refusal) => sum + refusal.places, 0);
  const later = `${wasPushed ? ', pushed aside later' : ''}${wasSentAway ? ', sent back to search once' : ''}`;
  return `${places} ${places === 1 ? 'place' : 'places'} tried, ${count} refused${later}`;
}

function refusalText({ reason, places, obstacles = [] }) {
  const names = obstacles.slice(0, MOST_OBSTACLES).map(({ name, places: times }) => `${name} ${times}`);
  const more = obstacles.length > MOST_OBSTACLES ? `, ${obstacles.length - MOST_OBSTACLES} more` : '';
  return `${places} × ${reason}${names.length > 0 ? `: ${names.join(', ')}${more}` : ''}`;
}
