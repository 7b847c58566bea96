# Sets up the environments of the scripts in the project's folder: `source scripts/set_up.sh` there.
# ROOMWRIGHT_PYTHON names another Python than python3.

# .venv/ from scripts/requirements.txt: for validate.py, convert.py and the tests.
set_up_python() {
  local python=${ROOMWRIGHT_PYTHON:-python3}
  [ -x .venv/bin/python ] || "$python" -m venv .venv
  # The stamp spares a second run the question.
  if ! cmp -s scripts/requirements.txt .venv/requirements.txt; then
    .venv/bin/python -m pip install --quiet --requirement scripts/requirements.txt
    cp scripts/requirements.txt .venv/requirements.txt
  fi
  .venv/bin/python --version
}

# python/roomwright/khronos/node_modules/ from the lock file: the Khronos validator that validate.py runs.
set_up_validator() {
  local folder=python/roomwright/khronos
  if ! cmp -s $folder/package-lock.json $folder/node_modules/.lock; then
    (cd $folder && npm ci --loglevel=error)
    cp $folder/package-lock.json $folder/node_modules/.lock
  fi
  node --version
}

# tests/viewers/node_modules/ from the lock file: three.js, Babylon.js, model-viewer and CesiumJS, 400 MB.
set_up_viewers() {
  if ! cmp -s tests/viewers/package-lock.json tests/viewers/node_modules/.lock; then
    (cd tests/viewers && npm ci --loglevel=error)
    cp tests/viewers/package-lock.json tests/viewers/node_modules/.lock
  fi
}

# tests/viewer/node_modules/ from the lock file: the driver of the browser that opens the page of `roomwright view`.
set_up_viewer() {
  if ! cmp -s tests/viewer/package-lock.json tests/viewer/node_modules/.lock; then
    (cd tests/viewer && npm ci --loglevel=error)
    cp tests/viewer/package-lock.json tests/viewer/node_modules/.lock
  fi
}
