using GTA.Native;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about controls, and those by which a vehicle is repositioned and the environment set.</summary>
internal sealed partial class TestGame
{
    private const float PressedFrom = 0.5f;
    private Dictionary<int, float> _coming = [];

    /// <summary>Controls that the player uses, by the game's numbers.</summary>
    public HashSet<int> PlayersControls { get; } = [];

    /// <summary>Controls that a script has set for this frame.</summary>
    public Dictionary<int, float> Controls { get; private set; } = [];

    /// <summary>The weather fixed by a script; null if there is none.</summary>
    public string? KeptWeather { get; private set; }

    private void PassControls()
    {
        Controls = _coming;
        _coming = [];
    }

    private void AddControlNatives()
    {
        // The game cannot distinguish a control used by the player from one set by a script.
        _natives[Hash.IS_CONTROL_PRESSED] = a =>
            PlayersControls.Contains((int)a[1]) || Math.Abs(Controls.GetValueOrDefault((int)a[1])) >= PressedFrom;
        _natives[Hash.GET_CONTROL_NORMAL] = a => PlayersControls.Contains((int)a[1]) ? 1f : Controls.GetValueOrDefault((int)a[1]);
        _natives[Hash.SET_CONTROL_VALUE_NEXT_FRAME] = a =>
        {
            Assert.Equal(0, (int)a[0]);
            Assert.InRange((float)a[2], -1, 1);
            _coming[(int)a[1]] = (float)a[2];
            return true;
        };
        Do(
            Hash.SET_ENTITY_COORDS_NO_OFFSET,
            a =>
            {
                GameEntity entity = Entities[(int)a[0]];
                entity.Pose = new Pose(ToWorld(a[1], a[2], a[3]), entity.Pose.Axes);
                entity.IsOnGround = false;
            }
        );
        Do(
            Hash.SET_ENTITY_HEADING,
            a =>
            {
                GameEntity entity = Entities[(int)a[0]];
                entity.Pose = new Pose(entity.Pose.Position, Axes.FromHeading((float)a[1]));
            }
        );
        Do(Hash.SET_ENTITY_VELOCITY, a => Entities[(int)a[0]].Velocity = ToWorld(a[1], a[2], a[3]));
        Do(
            Hash.SET_WEATHER_TYPE_NOW_PERSIST,
            a =>
            {
                string weather = (string)a[0];
                Assert.Equal(weather.ToUpperInvariant(), weather);
                Assert.True(WeatherNames.IsKnown(weather.ToLowerInvariant()));
                KeptWeather = weather.ToLowerInvariant();
                Environment = Environment with { Weather = KeptWeather };
            }
        );
        Do(Hash.CLEAR_WEATHER_TYPE_PERSIST, _ => KeptWeather = null);
        Do(Hash.SET_CLOCK_TIME, a => Environment = Environment with { TimeOfDay = new TimeSpan((int)a[0], (int)a[1], (int)a[2]) });
    }
}
