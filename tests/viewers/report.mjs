// A reporter for `node --test` that ends as cargo and pytest do: N passed, N failed, N skipped.

const ENDINGS = { 'test:pass': 'ok', 'test:fail': 'FAILED' };

export default async function* report(source) {
  const counts = { passed: 0, failed: 0, skipped: 0 };
  for await (const { type, data } of source) {
    if (type === 'test:diagnostic' && data.nesting > 0) yield `  ${data.message}\n`;
    const isSuite = data.details?.type === 'suite';
    const isSkipped = data.skip !== undefined;
    if (!(type in ENDINGS) || isSuite && type === 'test:pass' && !isSkipped) continue;
    yield line(type, data);
    if (!isSuite || isSkipped) counts[kind(type, data)] += 1;
  }
  yield `\n${counts.passed} passed, ${counts.failed} failed, ${counts.skipped} skipped\n`;
}

function kind(type, data) {
  if (data.skip !== undefined) return 'skipped';
  return type === 'test:pass' ? 'passed' : 'failed';
}

function line(type, data) {
  const reason = data.skip === undefined ? '' : ` (skipped: ${data.skip})`;
  const error = type === 'test:fail' ? `\n    ${data.details.error?.cause?.message ?? data.details.error?.message}` : '';
  return `${ENDINGS[type]} ${data.name}${reason}${error}\n`;
}
