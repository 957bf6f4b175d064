using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>Collects what a reader finds in a file of strangers, and checks it.</summary>
internal sealed class LogDraft
{
    private readonly List<LogTrack> _tracks = [];
    private readonly HashSet<int> _trackIds = [];
    private readonly List<LogFeature> _features = [];
    private readonly HashSet<long> _featureIds = [];
    private readonly SortedDictionary<string, int> _leftOut = new(StringComparer.Ordinal);
    private readonly Dictionary<int, int> _indices = [];
    private int _points;
    private int _listed;

    /// <summary>The lights at each step.</summary>
    public List<List<LogSignal>> Signals { get; } = [];

    /// <summary>Counts a thing that is left out.</summary>
    public void LeaveOut(string what) => _leftOut[what] = _leftOut.GetValueOrDefault(what) + 1;

    /// <summary>Adds the next track of the file.</summary>
    /// <param name="id">Its number.</param>
    /// <param name="kind">What it is; null if a log has no such thing.</param>
    /// <param name="states">Its states.</param>
    /// <exception cref="DatasetFormatException">Its number stands twice, or there are too many.</exception>
    public void Add(int id, TrafficLogKind? kind, IReadOnlyList<LogState?> states)
    {
        int index = _listed++;
        LogLimits.Require(
            _listed <= LogLimits.Tracks,
            FormattableString.Invariant($"it has more than {LogLimits.Tracks} tracks, the limit.")
        );
        LogLimits.Require(
            (long)_listed * states.Count <= LogLimits.States,
            FormattableString.Invariant($"it has more than {LogLimits.States} states of tracks, the limit.")
        );
        LogLimits.Require(_trackIds.Add(id), FormattableString.Invariant($"two tracks have the id {id}."));
        if (kind is not { } known)
        {
            LeaveOut("tracks of other kinds");
        }
        else if (states.All(static state => state is null))
        {
            LeaveOut("tracks without a valid state");
        }
        else
        {
            _indices.Add(index, _tracks.Count);
            _tracks.Add(new LogTrack(id, known, states));
        }
    }

    /// <summary>Adds a part of the map.</summary>
    /// <exception cref="DatasetFormatException">Its number stands twice, or there are too many.</exception>
    public void Add(LogFeature feature)
    {
        _points += feature.Points.Count;
        LogLimits.Require(
            _features.Count < LogLimits.Features && _points <= LogLimits.Points,
            FormattableString.Invariant($"its map has more than {LogLimits.Features} parts or {LogLimits.Points} points, the limits.")
        );
        LogLimits.Require(_featureIds.Add(feature.Id), FormattableString.Invariant($"two parts of the map have the id {feature.Id}."));
        _features.Add(feature);
    }

    /// <summary>A point of the map.</summary>
    /// <exception cref="DatasetFormatException">A coordinate is beyond the limit.</exception>
    public static Vector3D Point(double x, double y, double z) =>
        new(
            LogLimits.Within(x, LogLimits.Coordinate, "x of a point"),
            LogLimits.Within(y, LogLimits.Coordinate, "y of a point"),
            LogLimits.Within(z, LogLimits.Coordinate, "z of a point")
        );

    /// <summary>A state.</summary>
    /// <exception cref="DatasetFormatException">A value is beyond its limit.</exception>
    public static LogState State(Vector3D centre, (double Length, double Width, double Height) size, double heading, Vector2D velocity)
    {
        double Side(double side, string name) =>
            side > 0 ? LogLimits.Within(side, LogLimits.Side, name) : throw new DatasetFormatException($"{name} of a box is not positive.");
        return new LogState(
            centre,
            Side(size.Length, "length"),
            Side(size.Width, "width"),
            Side(size.Height, "height"),
            Math.IEEERemainder(LogLimits.Within(heading, LogLimits.Coordinate, "heading"), 2 * Math.PI),
            new Vector2D(
                LogLimits.Within(velocity.X, LogLimits.Speed, "a velocity"),
                LogLimits.Within(velocity.Y, LogLimits.Speed, "a velocity")
            )
        );
    }

    /// <summary>The log.</summary>
    /// <param name="id">Its name.</param>
    /// <param name="times">Times of its steps, seconds.</param>
    /// <param name="ego">Index of the recording car's track in the file.</param>
    /// <exception cref="DatasetFormatException">Its parts do not fit.</exception>
    public LogReading Finish(string id, IReadOnlyList<double> times, int ego)
    {
        LogLimits.Require(
            times.Count is > 0 and <= LogLimits.Steps,
            FormattableString.Invariant($"it has {times.Count} steps, which are not 1 to {LogLimits.Steps}.")
        );
        LogLimits.Require(
            times.Zip(times.Skip(1)).All(static pair => pair.Second > pair.First)
                && Math.Abs(times[0]) <= LogLimits.Coordinate
                && Math.Abs(times[^1]) <= LogLimits.Coordinate,
            "the times of its steps do not rise."
        );
        LogLimits.Require(_tracks.All(track => track.States.Count == times.Count), "a track has not as many states as there are steps.");
        LogLimits.Require(
            _indices.ContainsKey(ego),
            FormattableString.Invariant($"the recording car is track {ego}, which is not among its vehicles with a valid state.")
        );
        LogLimits.Require(_tracks[_indices[ego]].Kind == TrafficLogKind.Vehicle, "the recording car is no vehicle.");
        return new LogReading(new MotionLog(id, times, _tracks, _indices[ego], [.. _features.Select(WithoutStrangers)], Signals), _leftOut);
    }

    /// <summary>A lane of which others that are named are on no list is at the border of the map.</summary>
    private LogFeature WithoutStrangers(LogFeature feature)
    {
        IReadOnlyList<long> Known(IReadOnlyList<long> ids) => ids.All(_featureIds.Contains) ? ids : [.. ids.Where(_featureIds.Contains)];
        return feature with
        {
            Entries = Known(feature.Entries),
            Exits = Known(feature.Exits),
            LeftNeighbours = Known(feature.LeftNeighbours),
            RightNeighbours = Known(feature.RightNeighbours),
            LeftBoundaries = Known(feature.LeftBoundaries),
            RightBoundaries = Known(feature.RightBoundaries),
            Lanes = Known(feature.Lanes),
        };
    }
}
