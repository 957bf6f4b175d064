using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Play.Surveys.Roads;

/// <summary>
/// Roads that are prepared on another thread, so that the game never waits: those of a file, or repeatedly those of a survey as it grows.
/// All calls come from the game's thread.
/// </summary>
/// <param name="laneWidth">Width of the lanes of an ordinary road, metres.</param>
/// <param name="narrowLaneWidth">Width of the lanes of a narrow road, metres.</param>
public sealed class GrowingRoads(double laneWidth = RoadGeometry.LaneWidth, double narrowLaneWidth = RoadGeometry.NarrowLaneWidth)
    : IRoads,
        IRoadPaint
{
    private Task<(KnownRoads Known, MeasuredPaint? Paint)?>? _preparing;
    private KnownRoads? _known;
    private Task _mapping = Task.CompletedTask;
    private MeasuredPaint? _paint;

    /// <summary>Whether roads are being prepared; until then others are not accepted.</summary>
    public bool IsPreparing => _preparing is { } preparing && !Background.IsDone(nameof(GrowingRoads), () => preparing.IsCompleted);

    /// <inheritdoc/>
    public bool IsComplete => false;

    /// <inheritdoc/>
    public KnownRoads? Near(Vector3D position)
    {
        if (_preparing is { } prepared && Background.IsDone(nameof(Near), () => prepared.Status == TaskStatus.RanToCompletion))
        {
            _preparing = null;
            if (prepared.Result is { } ready)
            {
                (_known, _paint) = ready;
            }
        }

        if (_known is { } known && _mapping.IsCompleted)
        {
            // The same lanes whether they are ready in time or made when they are asked for, so labels do not depend on it.
            _mapping = Task.Run(() => known.Maps.Value.Prepare(position));
        }

        return _known;
    }

    /// <inheritdoc/>
    public IEnumerable<PaintedLine> Near(Vector3D place, double range) => _paint?.Near(place, range) ?? [];

    /// <inheritdoc/>
    public IEnumerable<PaintedMark> StopLinesNear(Vector3D place, double range) => _paint?.StopLinesNear(place, range) ?? [];

    /// <summary>Why the last roads could not be prepared; returned once. The earlier roads stay in use. Null if nothing failed.</summary>
    public Exception? TakeFailure()
    {
        Exception? failure = _preparing?.Exception?.InnerException;
        _preparing = failure is null ? _preparing : null;
        return failure;
    }

    /// <summary>Starts preparing a network; until it is ready, the current one stays in use.</summary>
    /// <param name="read">Returns the network; called on another thread.</param>
    /// <param name="source">Its source, as a short camelCase word for the labels.</param>
    /// <param name="readPaint">Returns the paint measured on the network; called on another thread. Null for none.</param>
    public void Prepare(Func<RoadNetwork> read, string source, Func<RoadNetwork, PaintTable>? readPaint = null)
    {
        if (!IsPreparing)
        {
            _preparing = Task.Run(() => Prepared(read(), source, readPaint));
        }
    }

    private (KnownRoads Known, MeasuredPaint? Paint)? Prepared(RoadNetwork network, string source, Func<RoadNetwork, PaintTable>? readPaint)
    {
        if (network.Links.Count == 0)
        {
            return null;
        }

        PaintTable? paint = readPaint?.Invoke(network);
        var roads = new FixedRoads(network, source, null, laneWidth, narrowLaneWidth, paint);
        if (roads.Near(default) is not { } known)
        {
            return null;
        }

        // Here rather than in the game's thread, at the first frame.
        _ = known.Maps.Value;
        return (known, paint is null ? null : new MeasuredPaint(paint));
    }
}
