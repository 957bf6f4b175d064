using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Surveys;

/// <summary>
/// The tour of a survey of paint. The vehicle is placed on the road at each station, so that the game loads the ground there; the camera
/// above it looks down, at noon in clear weather; in the frozen game, the vehicle itself and all other objects are hidden. At the end the
/// vehicle is back where it was.
/// </summary>
public sealed class PaintTour : IFrameTour
{
    private const string Weather = "clear";

    /// <summary>Objects farther from the vehicle than the picture reaches, by this much, are not hidden, metres: a lorry.</summary>
    private const double BeyondPicture = 15;

    /// <summary>Ticks after which the vehicle is placed again while the ground is missing, because it falls.</summary>
    private const int TicksBetweenPlacings = 10;

    /// <summary>Fraction of the picture's half length at which the ground must be loaded on the road ahead and behind.</summary>
    private const double ProbedFraction = 0.8;

    /// <summary>Farthest from its station that a vehicle may stand, metres: the border of the footprint that does not count.</summary>
    private const double MaxMiss = 1;

    private static readonly TimeSpan Noon = TimeSpan.FromHours(12);
    private readonly GamePorts _game;
    private readonly IDrivenCar _car;
    private readonly IReadOnlyList<SurveyStation> _stations;
    private readonly SurveyView _view;
    private readonly TourTimes _times;
    private readonly HashSet<int> _hidden = [];
    private EgoState? _home;
    private bool _isHiding;
    private int _place = -1;
    private int _left = -1;

    /// <summary>Creates a tour; the game is not used yet.</summary>
    /// <param name="game">The game, which can freeze, hide objects, set weather and time, and move its camera.</param>
    /// <param name="car">The vehicle with the camera.</param>
    /// <param name="stations">The stations.</param>
    /// <param name="view">The camera.</param>
    /// <param name="times">How long to wait.</param>
    public PaintTour(GamePorts game, IDrivenCar car, IReadOnlyList<SurveyStation> stations, SurveyView view, TourTimes times)
    {
        _game = game ?? throw new ArgumentNullException(nameof(game));
        _car = car ?? throw new ArgumentNullException(nameof(car));
        _stations = stations ?? throw new ArgumentNullException(nameof(stations));
        _view = view ?? throw new ArgumentNullException(nameof(view));
        _times = times ?? throw new ArgumentNullException(nameof(times));
    }

    /// <summary>The game for the harvest that makes the tour: its rays pass through what is hidden.</summary>
    public GamePorts Ports =>
        _game.SurfaceRays is { } rays && new RaysThroughHidden(rays, _hidden.Contains) is var through
            ? _game with
            {
                Rays = through,
                SurfaceRays = through,
            }
            : _game;

    /// <inheritdoc/>
    public int Count => _stations.Count;

    /// <inheritdoc/>
    public string? Obstacle { get; private set; }

    /// <summary>Whether all stations were visited.</summary>
    public bool HasVisitedAll => _left == _stations.Count - 1;

    /// <inheritdoc/>
    public IEnumerable<WorkStep> Approach(int place)
    {
        SurveyStation station = _stations[place];
        _place = place;
        _home ??= _game.World.ReadEgo();
        Obstacle = "groundNotLoaded";
        _game.Sky?.Set(Weather, Noon);
        for (int tick = 0; tick < _times.Loading && Obstacle is not null; tick++)
        {
            if (tick % TicksBetweenPlacings == 0)
            {
                _car.Reset(station.Ground, station.HeadingDegrees);
                _game.RigCamera?.Show(_view.Camera, _view.Camera.Mount);
            }

            yield return WorkStep.Tick;
            Obstacle = IsLoaded(station) ? null : Obstacle;
        }

        if (Obstacle is not null)
        {
            yield break;
        }

        _car.Reset(station.Ground, station.HeadingDegrees);
        for (int tick = 0; tick < _times.Standing; tick++)
        {
            _car.Drive(DrivingControls.Stop);
            yield return WorkStep.Tick;
        }

        _game.Pause.Freeze();
        Vector3D apart = _game.World.ReadEgo().Pose.Position - station.Ground;
        if (Math.Sqrt((apart.X * apart.X) + (apart.Y * apart.Y)) > MaxMiss)
        {
            Obstacle = "vehicleNotPlaced";
            yield break;
        }

        yield return WorkStep.Do(Hide(station));
    }

    /// <inheritdoc/>
    public void Leave()
    {
        _left = _place;
        _game.Pause.Unfreeze();
        ShowAll();
    }

    /// <inheritdoc/>
    public void Release()
    {
        try
        {
            ShowAll();
        }
        finally
        {
            GoHome();
        }
    }

    private void ShowAll()
    {
        if (_isHiding)
        {
            _hidden.Clear();
            _game.Visibility?.ShowAll();
            _isHiding = false;
        }
    }

    private void GoHome()
    {
        if (_home is not { } home)
        {
            return;
        }

        _home = null;
        try
        {
            _game.Sky?.Restore();
        }
        finally
        {
            if (home.Handle != 0 && _game.World.ReadEgo().Handle == home.Handle)
            {
                _car.Reset(home.Pose.Position, Angles.HeadingDegrees(home.Pose.Axes.Forward));
            }
        }
    }

    /// <summary>Hides the vehicle with the camera and all objects that the picture may show.</summary>
    private IEnumerable<WorkStep> Hide(SurveyStation station)
    {
        if (_game.Visibility is not { } visibility)
        {
            yield break;
        }

        double reach = _view.Footprint.HalfAlong + _view.Footprint.HalfAcross + BeyondPicture;
        int[] entities =
        [
            .. _game.World.ReadEntities(station.Ground, reach).Select(entity => entity.Handle).Append(_game.World.ReadEgo().Handle),
        ];
        _isHiding = true;
        IReadOnlyCollection<int>? hideable;
        while ((hideable = visibility.Announce(entities)) is null)
        {
            yield return WorkStep.Tick;
        }

        visibility.HideOnly(hideable);
        _hidden.UnionWith(hideable);
        for (int tick = 0; tick < _times.Hiding; tick++)
        {
            yield return WorkStep.Tick;
        }
    }

    /// <summary>Whether rays from the camera's height meet the ground under it, and on the road ahead and behind.</summary>
    private bool IsLoaded(SurveyStation station)
    {
        int ego = _game.World.ReadEgo().Handle;
        double half = ProbedFraction * _view.Footprint.HalfAlong;
        return new[] { 0, half, -half }.All(along =>
        {
            Vector2D ahead = station.Forward * along;
            var from = new Vector3D(station.Ground.X + ahead.X, station.Ground.Y + ahead.Y, station.Ground.Z + _view.HeightMetres);
            return _game.Rays.Cast(new Ray(from, new Vector3D(0, 0, -1)), 2 * _view.HeightMetres, ego) is not null;
        });
    }
}
