using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Play.Surveys.Roads;

/// <summary>
/// Roads that are prepared on another thread, so that the game never waits: those of a file, or repeatedly those of a survey as it grows.
/// All calls come from the game's thread.
/// </summary>
/// <param name="laneWidth">Width of the lanes of an ordinary road, metres.</param>
/// <param name="narrowLaneWidth">Width of the lanes of a narrow road, metres.</param>
public sealed class GrowingRoads(double laneWidth = RoadGeometry.LaneWidth, double narrowLaneWidth = RoadGeometry.NarrowLaneWidth) : IRoads
{
    private Task<KnownRoads?>? _preparing;
    private KnownRoads? _known;

    /// <summary>Whether roads are being prepared; until then others are not accepted.</summary>
    public bool IsPreparing => _preparing is { } preparing && !Background.IsDone(nameof(GrowingRoads), () => preparing.IsCompleted);

    /// <inheritdoc/>
    public KnownRoads? Near(Vector3D position)
    {
        if (_preparing is { } prepared && Background.IsDone(nameof(Near), () => prepared.Status == TaskStatus.RanToCompletion))
        {
            _preparing = null;
            _known = prepared.Result ?? _known;
        }

        return _known;
    }

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
    public void Prepare(Func<RoadNetwork> read, string source)
    {
        if (!IsPreparing)
        {
            _preparing = Task.Run<KnownRoads?>(() =>
            {
                RoadNetwork network = read();
                return network.Links.Count > 0 ? new FixedRoads(network, source, null, laneWidth, narrowLaneWidth).Near(default) : null;
            });
        }
    }
}
