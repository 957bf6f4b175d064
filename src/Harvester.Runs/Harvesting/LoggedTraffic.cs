using Harvester.Datasets.Logs;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Harvesting;

/// <summary>The traffic of an imported log as the simulated game replays it.</summary>
public static class LoggedTraffic
{
    /// <summary>The file of roads in the folder of a log.</summary>
    /// <param name="folder">The folder.</param>
    public static string RoadsOf(string folder) => Path.Combine(folder, TrafficFile.Roads);

    /// <summary>Time from the first step of a log at which its car is known to the last, seconds.</summary>
    /// <param name="folder">The folder of the log.</param>
    /// <exception cref="DatasetFormatException">Its file is invalid.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static double SecondsOf(string folder) => Read(folder).Times[^1];

    /// <summary>Reads the traffic of a log. Its time begins with the first step at which its car is known and ends with the last.</summary>
    /// <param name="folder">The folder of the log.</param>
    /// <exception cref="DatasetFormatException">Its file is invalid.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static TrafficReplay Read(string folder)
    {
        MotionLog log = TrafficFile.Read(Path.Combine(folder, TrafficFile.Name));
        IReadOnlyList<LogState?> ego = log.Tracks[log.Ego].States;
        int first = ego.Index().First(state => state.Item is not null).Index;
        int last = ego.Index().Last(state => state.Item is not null).Index;
        return new TrafficReplay(
            [.. log.Times.Skip(first).Take(last - first + 1).Select(time => time - log.Times[first])],
            [.. log.Tracks.Select(track => TrackOf(track, first, last))],
            log.Ego
        );
    }

    /// <summary>Where the car of a replay begins, metres, world x and y.</summary>
    internal static Vector2D StartOf(TrafficReplay replay)
    {
        Vector3D place = replay.Tracks[replay.Ego].States[0]!.Value.Centre;
        return new Vector2D(place.X, place.Y);
    }

    private static ReplayTrack TrackOf(LogTrack track, int first, int last)
    {
        LogState size = track.States.First(state => state is not null)!.Value;
        return new ReplayTrack(
            track.Kind switch
            {
                TrafficLogKind.Pedestrian => ReplayKind.Pedestrian,
                TrafficLogKind.Cyclist => ReplayKind.Cyclist,
                _ => ReplayKind.Vehicle,
            },
            new Vector3D(size.Width, size.Length, size.Height),
            [
                .. track
                    .States.Skip(first)
                    .Take(last - first + 1)
                    .Select(state =>
                        state is { } known ? new ReplayState(known.Centre, known.Heading, known.Velocity) : (ReplayState?)null
                    ),
            ]
        );
    }
}
