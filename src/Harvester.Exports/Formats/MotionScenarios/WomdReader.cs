using Google.Protobuf;
using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;
using Womd;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>Reads scenarios from files of WOMD.</summary>
internal static class WomdReader
{
    /// <summary>Reads the scenarios of a file, one at a time.</summary>
    /// <exception cref="DatasetFormatException">The file is not of WOMD, or too large; the message refers to it as "it".</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static IEnumerable<LogReading> Read(string path)
    {
        using FileStream stream = InputFile.OpenRead(path);
        foreach (byte[] record in TfRecord.Read(stream))
        {
            yield return Of(record);
        }
    }

    /// <summary>Reads a scenario.</summary>
    /// <exception cref="DatasetFormatException">The bytes are none; the message refers to the file as "it".</exception>
    public static LogReading Of(byte[] record)
    {
        Scenario scenario;
        try
        {
            scenario = Scenario.Parser.ParseFrom(record);
        }
        catch (InvalidProtocolBufferException e)
        {
            throw new DatasetFormatException("a record in it is no Scenario message.", e);
        }

        var draft = new LogDraft();
        foreach (Track track in scenario.Tracks)
        {
            LogLimits.Require(
                track.States.Count <= LogLimits.Steps,
                FormattableString.Invariant($"a track has more than {LogLimits.Steps} states, the limit.")
            );
            draft.Add(
                track.Id,
                Enum.IsDefined((TrafficLogKind)track.ObjectType) ? (TrafficLogKind)track.ObjectType : null,
                [.. track.States.Select(StateOf)]
            );
        }

        foreach (MapFeature feature in scenario.MapFeatures)
        {
            AddFeature(draft, feature);
        }

        foreach (DynamicMapState state in scenario.DynamicMapStates)
        {
            LogLimits.Require(draft.Signals.Count < LogLimits.Steps, "it has more states of lights than steps.");
            draft.Signals.Add([.. state.LaneStates.Select(SignalOf)]);
        }

        int steps = scenario.TimestampsSeconds.Count;
        LogLimits.Require(draft.Signals.Count <= steps, "it has more states of lights than steps.");
        while (draft.Signals.Count < Math.Min(steps, LogLimits.Steps))
        {
            draft.Signals.Add([]);
        }

        return draft.Finish(scenario.ScenarioId, [.. scenario.TimestampsSeconds], scenario.SdcTrackIndex);
    }

    private static LogState? StateOf(ObjectState state) =>
        state.Valid
            ? LogDraft.State(
                LogDraft.Point(state.CenterX, state.CenterY, state.CenterZ),
                (state.Length, state.Width, state.Height),
                state.Heading,
                new Vector2D(state.VelocityX, state.VelocityY)
            )
            : null;

    private static LogSignal SignalOf(TrafficSignalLaneState state) =>
        new(
            state.Lane,
            Enum.IsDefined((LogLight)state.State) ? (LogLight)state.State : LogLight.Unknown,
            PointOf(state.StopPoint ?? new MapPoint())
        );

    private static void AddFeature(LogDraft draft, MapFeature feature)
    {
        (LogFeatureKind Kind, int Type, IEnumerable<MapPoint> Points)? content = feature.FeatureDataCase switch
        {
            MapFeature.FeatureDataOneofCase.Lane => (LogFeatureKind.Lane, feature.Lane.Type, feature.Lane.Polyline),
            MapFeature.FeatureDataOneofCase.RoadLine => (LogFeatureKind.RoadLine, feature.RoadLine.Type, feature.RoadLine.Polyline),
            MapFeature.FeatureDataOneofCase.RoadEdge => (LogFeatureKind.RoadEdge, feature.RoadEdge.Type, feature.RoadEdge.Polyline),
            MapFeature.FeatureDataOneofCase.StopSign => (LogFeatureKind.StopSign, 0, [feature.StopSign.Position ?? new MapPoint()]),
            MapFeature.FeatureDataOneofCase.Crosswalk => (LogFeatureKind.Crosswalk, 0, feature.Crosswalk.Polygon),
            MapFeature.FeatureDataOneofCase.SpeedBump => (LogFeatureKind.SpeedBump, 0, feature.SpeedBump.Polygon),
            MapFeature.FeatureDataOneofCase.Driveway => (LogFeatureKind.Driveway, 0, feature.Driveway.Polygon),
            _ => null,
        };
        if (content is not { } known)
        {
            draft.LeaveOut("parts of the map of other kinds");
            return;
        }

        Vector3D[] points = [.. known.Points.Take(LogLimits.Points + 1).Select(PointOf)];
        if (points.Length < (known.Kind == LogFeatureKind.StopSign ? 1 : 2))
        {
            draft.LeaveOut("parts of the map with too few points");
            return;
        }

        int type = known.Type >= 0 && known.Type <= GpuDriveNames.MaxTypeOf(known.Kind) ? known.Type : 0;
        LaneCenter? lane = feature.Lane;
        draft.Add(
            new LogFeature(feature.Id, known.Kind, type, points)
            {
                IsWay = lane?.Interpolating ?? false,
                Entries = [.. lane?.EntryLanes ?? []],
                Exits = [.. lane?.ExitLanes ?? []],
                LeftNeighbours = [.. lane?.LeftNeighbors.Select(beside => beside.FeatureId).Distinct() ?? []],
                RightNeighbours = [.. lane?.RightNeighbors.Select(beside => beside.FeatureId).Distinct() ?? []],
                LeftBoundaries = [.. lane?.LeftBoundaries.Select(line => line.BoundaryFeatureId).Distinct() ?? []],
                RightBoundaries = [.. lane?.RightBoundaries.Select(line => line.BoundaryFeatureId).Distinct() ?? []],
                Lanes = [.. feature.StopSign?.Lane ?? []],
            }
        );
    }

    private static Vector3D PointOf(MapPoint point) => LogDraft.Point(point.X, point.Y, point.Z);
}
