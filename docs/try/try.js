// The page begins here: a plan is taken, furnished by the program in the worker, shown by the viewer, and its levels are saved.
import { Server } from './viewer/src/server/server.js';
import { openViewer } from './viewer/src/viewer.js';
import { WorkerTransport } from './transport.js';

/** The sample, and the name in faults of a text without a file. */
const [SAMPLE, PASTED] = ['house.yaml', 'plan.yaml'];

const byId = (id) => document.getElementById(id);
const transport = new WorkerTransport(new Worker('./worker.js', { type: 'module' }));
let app = null;
let name = PASTED;

function tell(text) {
  byId('told').textContent = text;
}

/** Runs what a button asks for; meanwhile no other button works. */
async function busy(task) {
  byId('furnish').disabled = true;
  try {
    await task();
  } catch (error) {
    tell(error.message);
  }
  byId('furnish').disabled = false;
}

async function take(file) {
  name = file.name;
  byId('plan').value = await file.text();
  await furnish();
}

async function takeSample() {
  const response = await fetch(SAMPLE);
  if (!response.ok) throw new Error(`The sample is not there: the host answers ${response.status}.`);
  name = SAMPLE;
  byId('plan').value = await response.text();
  await furnish();
}

async function furnish() {
  tell('Reading the plan …');
  const seed = byId('begin-seed').value;
  const { status, bytes } = await transport.open(name, byId('plan').value, seed === '' ? null : Number(seed));
  if (status !== 200) throw new Error(new TextDecoder().decode(bytes));
  tell('');
  await show();
}

/** The viewer has its elements from its own page, so that they are written once. */
async function show() {
  if (!app) {
    const text = await (await fetch('./viewer/index.html')).text();
    byId('viewer').append(...new DOMParser().parseFromString(text, 'text/html').body.children);
  }
  showPart('viewer');
  if (app) await app.open();
  else app = openViewer(new Server(transport));
}

function showPart(part) {
  for (const id of ['begin', 'viewer']) byId(id).hidden = id !== part;
  byId('another').hidden = part === 'begin';
  byId('save').hidden = part === 'begin';
  byId('back').hidden = part !== 'begin' || app === null;
}

async function saveLevel() {
  const { building, level } = app.place;
  tell('Writing the level …');
  const { status, bytes } = await transport.level({ building, level });
  if (status !== 200) throw new Error(new TextDecoder().decode(bytes));
  tell('');
  const address = URL.createObjectURL(new Blob([bytes], { type: 'model/gltf-binary' }));
  const link = Object.assign(document.createElement('a'), { href: address, download: `${building}-${level}.glb` });
  link.click();
  // The browser reads the file after this turn.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

byId('begin').addEventListener('submit', (event) => {
  event.preventDefault();
  busy(furnish);
});
byId('sample').addEventListener('click', () => busy(takeSample));
byId('file').addEventListener('change', ({ target }) => target.files[0] && busy(() => take(target.files[0])));
byId('plan').addEventListener('input', () => { name = PASTED; });
byId('another').addEventListener('click', () => showPart('begin'));
byId('back').addEventListener('click', () => showPart('viewer'));
byId('save').addEventListener('click', () => busy(saveLevel));
document.addEventListener('dragover', (event) => event.preventDefault());
document.addEventListener('drop', (event) => {
  event.preventDefault();
  const [file] = event.dataTransfer.files;
  if (file) busy(() => take(file));
});
