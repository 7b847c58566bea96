"""The parts of check_plans.py and plan_statistics.py: native plans, their checks and their statistics."""
