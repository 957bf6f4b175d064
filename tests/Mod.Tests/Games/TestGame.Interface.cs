using System.Text;
using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Play.Features;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives for drawing, time and weather.</summary>
internal sealed partial class TestGame
{
    private const int MaxTextLength = 99;

    /// <summary>How many texts the game's labels have room for.</summary>
    private static readonly Dictionary<string, int> Labels = new() { ["STRING"] = 1, ["CELL_EMAIL_BCON"] = 10 };

    private readonly List<string> _texts = [];
    private int _maxTexts;

    /// <summary>What this frame draws, as fractions of the window.</summary>
    public List<DrawnRectangle> Drawn { get; } = [];

    /// <summary>Where it draws them.</summary>
    public IReadOnlyList<Box2D> Rectangles => [.. Drawn.Select(rectangle => rectangle.Place)];

    /// <summary>The lines that this frame shows.</summary>
    public List<DrawnText> Lines { get; } = [];

    public IReadOnlyList<string> Texts => [.. Lines.Select(line => line.Text)];

    public bool IsHudHidden { get; private set; }

    public bool IsFeedHidden { get; private set; }

    /// <summary>Whether scripts leave the radar and the head-up display on.</summary>
    public bool IsRadarOn { get; set; } = true;

    public bool IsHudOn { get; set; } = true;

    /// <summary>Whether HIDE_HUD_AND_RADAR_THIS_FRAME has an effect while the game is paused.</summary>
    public bool HidesHudWhilePaused { get; set; } = true;

    /// <summary>Whether DISPLAY_RADAR and DISPLAY_HUD have an effect while the game is paused.</summary>
    public bool SwitchesHudWhilePaused { get; set; } = true;

    /// <summary>Whether the picture of the frame before shows the radar.</summary>
    public bool ShowedRadar { get; private set; }

    /// <summary>What the picture of the frame before shows over the game.</summary>
    public IReadOnlyList<DrawnRectangle> ShownRectangles { get; private set; } = [];

    /// <summary>The roads; null if there are none.</summary>
    public IRoadSource? Roads { get; set; }

    /// <summary>Balls that this frame draws.</summary>
    public List<PlannedMarker> Balls { get; } = [];

    /// <summary>Told at the end of each frame which balls it drew.</summary>
    public Action<IReadOnlyList<PlannedMarker>> BallsDrawn { get; set; } = _ => { };

    public EnvironmentState Environment { get; set; } = new("clear", new TimeSpan(12, 0, 0));

    /// <summary>Whether the picture of the frame before shows something of the game's display or of the mod's.</summary>
    public bool ShowedDisplay { get; private set; } = true;

    private void ClearDrawings()
    {
        bool isHiddenForFrame = IsHudHidden && (HidesHudWhilePaused || !IsFrozen);
        bool isSwitchedOff = !IsRadarOn && (SwitchesHudWhilePaused || !IsFrozen);
        ShowedRadar = !isHiddenForFrame && !isSwitchedOff;
        ShowedDisplay = !IsHudHidden || !IsFeedHidden || Drawn.Count > 0 || Lines.Count > 0;
        ShownRectangles = [.. Drawn];
        BallsDrawn([.. Balls]);
        Balls.Clear();
        Drawn.Clear();
        Lines.Clear();
        IsHudHidden = false;
        IsFeedHidden = false;
    }

    private void AddInterfaceNatives()
    {
        _natives[Hash.GET_FRAME_COUNT] = _ => Frame;
        _natives[Hash.GET_GAME_TIMER] = _ => TimerMilliseconds;
        _natives[Hash.GET_CLOCK_HOURS] = _ => Environment.TimeOfDay.Hours;
        _natives[Hash.GET_CLOCK_MINUTES] = _ => Environment.TimeOfDay.Minutes;
        _natives[Hash.GET_CLOCK_SECONDS] = _ => Environment.TimeOfDay.Seconds;
        _natives[Hash.GET_PREV_WEATHER_TYPE_HASH_NAME] = _ => ModelHash.Of(Environment.Weather);
        Do(
            Hash.DRAW_MARKER,
            a =>
            {
                Assert.Equal(28, (int)a[0]);
                Assert.Equal([a[10], a[10]], [a[11], a[12]]);
                Balls.Add(new PlannedMarker(ToWorld(a[1], a[2], a[3]), (float)a[10], default));
            }
        );
        Do(Hash.DRAW_POLY, _ => { });
        Do(Hash.HIDE_HUD_AND_RADAR_THIS_FRAME, _ => IsHudHidden = true);
        Do(Hash.DISPLAY_RADAR, a => IsRadarOn = (bool)a[0]);
        Do(Hash.DISPLAY_HUD, a => IsHudOn = (bool)a[0]);
        _natives[Hash.IS_RADAR_HIDDEN] = _ => !IsRadarOn || IsHudHidden;
        _natives[Hash.IS_HUD_HIDDEN] = _ => !IsHudOn || IsHudHidden;
        _natives[Hash.IS_RADAR_PREFERENCE_SWITCHED_ON] = _ => true;
        _natives[Hash.IS_HUD_PREFERENCE_SWITCHED_ON] = _ => true;
        Do(Hash.THEFEED_HIDE_THIS_FRAME, _ => IsFeedHidden = true);
        Do(
            Hash.DRAW_RECT,
            a =>
            {
                float x = (float)a[0],
                    y = (float)a[1],
                    width = (float)a[2],
                    height = (float)a[3];
                var place = new Box2D(x - (width / 2), y - (height / 2), x + (width / 2), y + (height / 2));
                Drawn.Add(new DrawnRectangle(place, new Colour((int)a[4], (int)a[5], (int)a[6])));
            }
        );
        Do(
            Hash.ADD_TEXT_COMPONENT_SUBSTRING_PLAYER_NAME,
            a =>
            {
                string text = (string)a[0];
                _texts.Add(text);
                ReportMarkup(text);
                if (Encoding.UTF8.GetByteCount(text) > MaxTextLength)
                {
                    Report($"The text is longer than {MaxTextLength} bytes: {text}");
                }

                if (_texts.Count > _maxTexts)
                {
                    Report($"The label has room for {_maxTexts} texts only: {text}");
                }
            }
        );
        Do(Hash.END_TEXT_COMMAND_DISPLAY_TEXT, a => Lines.Add(new DrawnText(string.Concat(_texts), (float)a[0], (float)a[1])));
        Do(
            Hash.BEGIN_TEXT_COMMAND_DISPLAY_TEXT,
            a =>
            {
                _texts.Clear();
                _maxTexts = Labels[(string)a[0]];
            }
        );
        foreach (Hash style in new[] { Hash.SET_TEXT_FONT, Hash.SET_TEXT_SCALE, Hash.SET_TEXT_COLOUR, Hash.SET_TEXT_OUTLINE })
        {
            Do(style, _ => { });
        }
    }
}
