using Google.Protobuf;
using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Womd;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>Writes a scenario as WOMD's Scenario message.</summary>
internal static class WomdScenario
{
    /// <summary>The message of a log.</summary>
    public static byte[] Bytes(MotionLog log)
    {
        var scenario = new Scenario
        {
            ScenarioId = log.Id,
            SdcTrackIndex = log.Ego,
            CurrentTimeIndex = PredictionTargets.PresentOf(log),
        };
        scenario.TimestampsSeconds.Add(log.Times);
        scenario.Tracks.Add(log.Tracks.Select(TrackOf));
        scenario.TracksToPredict.Add(
            PredictionTargets.Of(log).Select(static index => new RequiredPrediction { TrackIndex = index, Difficulty = 0 })
        );
        scenario.DynamicMapStates.Add(log.Signals.Select(StateOf));
        Dictionary<long, LogFeature> features = log.Features.ToDictionary(static feature => feature.Id);
        scenario.MapFeatures.Add(log.Features.Select(feature => FeatureOf(feature, features)));
        return scenario.ToByteArray();
    }

    private static Track TrackOf(LogTrack track)
    {
        var message = new Track { Id = track.Id, ObjectType = (int)track.Kind };
        message.States.Add(
            track.States.Select(static state =>
                state is not { } known
                    ? new ObjectState { Valid = false }
                    : new ObjectState
                    {
                        CenterX = known.Centre.X,
                        CenterY = known.Centre.Y,
                        CenterZ = known.Centre.Z,
                        Length = (float)known.Length,
                        Width = (float)known.Width,
                        Height = (float)known.Height,
                        Heading = (float)known.Heading,
                        VelocityX = (float)known.Velocity.X,
                        VelocityY = (float)known.Velocity.Y,
                        Valid = true,
                    }
            )
        );
        return message;
    }

    private static DynamicMapState StateOf(IReadOnlyList<LogSignal> signals)
    {
        var message = new DynamicMapState();
        message.LaneStates.Add(
            signals.Select(static signal => new TrafficSignalLaneState
            {
                Lane = signal.Lane,
                State = (int)signal.Light,
                StopPoint = PointOf(signal.Stop),
            })
        );
        return message;
    }

    private static MapFeature FeatureOf(LogFeature feature, Dictionary<long, LogFeature> features)
    {
        var message = new MapFeature { Id = feature.Id };
        IEnumerable<MapPoint> points = feature.Points.Select(PointOf);
        switch (feature.Kind)
        {
            case LogFeatureKind.Lane:
                message.Lane = LaneOf(feature, features);
                break;
            case LogFeatureKind.RoadLine:
                message.RoadLine = new RoadLine { Type = feature.Type };
                message.RoadLine.Polyline.Add(points);
                break;
            case LogFeatureKind.RoadEdge:
                message.RoadEdge = new RoadEdge { Type = feature.Type };
                message.RoadEdge.Polyline.Add(points);
                break;
            case LogFeatureKind.StopSign:
                message.StopSign = new StopSign { Position = PointOf(feature.Points[0]) };
                message.StopSign.Lane.Add(feature.Lanes);
                break;
            default:
                var area = new Area();
                area.Polygon.Add(points);
                Place(message, feature.Kind, area);
                break;
        }

        return message;
    }

    private static void Place(MapFeature message, LogFeatureKind kind, Area area)
    {
        switch (kind)
        {
            case LogFeatureKind.Crosswalk:
                message.Crosswalk = area;
                break;
            case LogFeatureKind.SpeedBump:
                message.SpeedBump = area;
                break;
            default:
                message.Driveway = area;
                break;
        }
    }

    private static LaneCenter LaneOf(LogFeature feature, Dictionary<long, LogFeature> features)
    {
        var lane = new LaneCenter { Type = feature.Type, Interpolating = feature.IsWay };
        lane.Polyline.Add(feature.Points.Select(PointOf));
        lane.EntryLanes.Add(feature.Entries);
        lane.ExitLanes.Add(feature.Exits);
        LaneNeighbor Beside(long id) =>
            new()
            {
                FeatureId = id,
                SelfStartIndex = 0,
                SelfEndIndex = feature.Points.Count - 1,
                NeighborStartIndex = 0,
                NeighborEndIndex = features[id].Points.Count - 1,
            };
        BoundarySegment Along(long id) =>
            new()
            {
                LaneStartIndex = 0,
                LaneEndIndex = feature.Points.Count - 1,
                BoundaryFeatureId = id,
                BoundaryType = features[id].Kind == LogFeatureKind.RoadLine ? features[id].Type : 0,
            };
        lane.LeftNeighbors.Add(feature.LeftNeighbours.Select(Beside));
        lane.RightNeighbors.Add(feature.RightNeighbours.Select(Beside));
        lane.LeftBoundaries.Add(feature.LeftBoundaries.Select(Along));
        lane.RightBoundaries.Add(feature.RightBoundaries.Select(Along));
        return lane;
    }

    private static MapPoint PointOf(Vector3D point) =>
        new()
        {
            X = point.X,
            Y = point.Y,
            Z = point.Z,
        };
}
