using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Events;

/// <summary>Finds the events of a harvest: reads the game in its ticks, and knows which frames an event spans.</summary>
/// <param name="options">How often and how far to read.</param>
/// <param name="game">The game.</param>
/// <param name="idOf">The id of an object in labels.</param>
/// <param name="firstId">Number of the first event.</param>
internal sealed class EventRecorder(EventOptions options, GamePorts game, Func<EntityState, int> idOf, int firstId)
{
    /// <summary>Times closer than this, seconds, are equal: labels have six decimals.</summary>
    private const double TimeTolerance = 1e-6;

    private readonly EventDetector _detector = new(idOf, firstId);
    private readonly StopLines _lines = new(game.Lights, game.Paint);
    private readonly List<(int First, int Last, double Seconds)> _frames = [];
    private readonly List<DrivingEvent> _earlier = [];
    private double _next = double.NegativeInfinity;
    private double _last = double.NegativeInfinity;

    /// <summary>Reads the game, if a reading is due.</summary>
    public void Observe()
    {
        IWorld world = game.World;
        double time = world.TimeSeconds;
        if (time < _last - TimeTolerance)
        {
            // A game that was loaded again begins at an earlier time, at which the frames so far do not count.
            _detector.Lose(_last);
            _earlier.AddRange(_detector.Book.Take(static _ => true).Select(each => WithFrames(each.Event)));
            _frames.Clear();
            _next = double.NegativeInfinity;
        }
        else if (time < _next - TimeTolerance || time <= _last + TimeTolerance)
        {
            return;
        }

        _next = time + (1 / options.RateHz);
        _last = time;
        EgoState ego = world.ReadEgo();
        if (ego.Handle == 0 || ego.ModelMin == ego.ModelMax)
        {
            _detector.Lose(time);
            return;
        }

        IReadOnlyList<EntityState> entities = world.ReadEntities(ego.Pose.Position, options.RangeMetres);
        _detector.Observe(time, ego, entities, RoadsAround(ego.Pose.Position, entities));
    }

    /// <summary>The roads around the ego, whose map reaches as far as other road users are read; null if they are not known.</summary>
    private RoadScene? RoadsAround(Vector3D place, IReadOnlyList<EntityState> entities) =>
        game.Roads?.Near(place)?.Maps.Value.Around(place) is { } map
            ? new RoadScene(map, _lines.At(map, entities, game.World.TimeSeconds, game.World.GameFrame))
            : null;

    /// <summary>Notes a frame, or all views of a moment, whether or not it is this session that writes it.</summary>
    /// <param name="first">Its number, or that of the first view.</param>
    /// <param name="views">Number of views.</param>
    /// <param name="seconds">The game's time that it shows, seconds.</param>
    public void Note(int first, int views, double seconds) => _frames.Add((first, first + views - 1, seconds));

    /// <summary>The events of a frame that was noted, once each.</summary>
    /// <param name="seconds">The game's time that it shows, seconds.</param>
    public TakenEvents TakeAt(double seconds)
    {
        EventSpan[] open =
        [
            .. _detector
                .Book.Open.Where(each => each.Begin <= seconds + TimeTolerance)
                .Select(static each => new EventSpan(each.Mark.Id, each.Mark.Kind, each.Begin, double.PositiveInfinity))
                .Concat(
                    _detector
                        .Book.Closed.Where(each =>
                            each.ClosedSeconds > seconds + TimeTolerance && each.Event.BeginSeconds <= seconds + TimeTolerance
                        )
                        .Select(static each => new EventSpan(
                            each.Event.Id,
                            each.Event.Kind,
                            each.Event.BeginSeconds,
                            double.PositiveInfinity
                        ))
                )
                .OrderBy(static span => span.Id),
        ];
        DrivingEvent[] ended =
        [
            .. _earlier,
            .. _detector.Book.Take(each => each.ClosedSeconds <= seconds + TimeTolerance).Select(each => WithFrames(each.Event)),
        ];
        _earlier.Clear();
        double oldest = _detector
            .Book.Open.Select(static each => each.Begin)
            .Concat(_detector.Book.Closed.Select(static each => each.Event.BeginSeconds))
            .DefaultIfEmpty(seconds)
            .Min();
        _frames.RemoveAll(frame => frame.Seconds < oldest - TimeTolerance);
        return new TakenEvents(open, ended);
    }

    /// <summary>Ends all events and takes those that are left.</summary>
    /// <param name="lost">The events of frames that were given up.</param>
    /// <param name="lastFrame">Number of the last frame that is part of the session; later ones were given up.</param>
    public IReadOnlyList<DrivingEvent> Finish(IEnumerable<DrivingEvent> lost, int lastFrame)
    {
        _detector.Book.CloseAll(EventEnd.SessionEnd, _last);
        IEnumerable<DrivingEvent> left = _detector.Book.Take(static _ => true).Select(each => WithFrames(each.Event));
        return [.. lost.Concat(_earlier).Concat(left).Select(each => Through(each, lastFrame))];
    }

    /// <summary>The event with those of its frames that are part of the session.</summary>
    private static DrivingEvent Through(DrivingEvent happened, int lastFrame) =>
        happened.FirstFrame > lastFrame ? happened with { FirstFrame = null, LastFrame = null }
        : happened.LastFrame > lastFrame ? happened with { LastFrame = lastFrame }
        : happened;

    private DrivingEvent WithFrames(DrivingEvent happened)
    {
        List<(int First, int Last, double Seconds)> spanned = _frames.FindAll(frame =>
            frame.Seconds >= happened.BeginSeconds - TimeTolerance && frame.Seconds <= happened.EndSeconds + TimeTolerance
        );
        return spanned.Count == 0 ? happened : happened with { FirstFrame = spanned[0].First, LastFrame = spanned[spanned.Count - 1].Last };
    }
}
