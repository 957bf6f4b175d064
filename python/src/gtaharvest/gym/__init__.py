"""Drives in the simulated game, or in GTA V, as an environment of Gymnasium. docs/gym.md of the project describes it.

The package gymnasium is not needed. If it is installed, the environment is a gymnasium.Env with its spaces, registered as
`gtaharvest/Driving-v0`.
"""

from .env import DrivingEnv
from .errors import BridgeError, GameEndedError, GameHungError, GameRefusedError, GameStartError, VersionError
from .lane_keeping import LaneKeeping
from .link import PROTOCOL_VERSION, BridgeLink
from .rewards import Reward
from .rules import Ending
from .score import Episode, EpisodeCounter, Rate, driving_score, mean_interval, poisson_interval, rates_per_km
from .server import GameServer
from .spaces import Box, Dict, gymnasium_module
from .state import STATE_NAMES
from .vector import SideBySide

__all__ = [
    "Box",
    "BridgeError",
    "BridgeLink",
    "Dict",
    "DrivingEnv",
    "Ending",
    "Episode",
    "EpisodeCounter",
    "GameEndedError",
    "GameHungError",
    "GameRefusedError",
    "GameServer",
    "GameStartError",
    "LaneKeeping",
    "PROTOCOL_VERSION",
    "Rate",
    "Reward",
    "STATE_NAMES",
    "SideBySide",
    "VersionError",
    "driving_score",
    "mean_interval",
    "poisson_interval",
    "rates_per_km",
]

if gymnasium_module is not None:
    gymnasium_module.register(id="gtaharvest/Driving-v0", entry_point="gtaharvest.gym:DrivingEnv")
