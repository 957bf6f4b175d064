using System.Globalization;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The motion of the ego in a scene.</summary>
/// <param name="All">Every tick that is known, in order.</param>
internal sealed record NuScenesRide(IReadOnlyList<NuScenesMoment> All)
{
    /// <summary>Separates the area and the rows of a part.</summary>
    public const char Separator = ';';

    /// <summary>Distance between the points of a route, metres.</summary>
    private const double RouteStep = 1;

    /// <summary>A sample as text: timestamp, time, position of the model, position of the ego, right, forward, velocity, motion.</summary>
    public static string Row(MotionSample sample, Func<double, long> timestampOf, Vector3D origin)
    {
        Vector3D place = sample.Pose.ToWorld(origin);
        List<double> numbers =
        [
            sample.TimeSeconds,
            .. Of(sample.Position),
            .. Of(place),
            .. Of(sample.Right),
            .. Of(sample.Forward),
            .. Of(sample.Velocity),
        ];
        if (sample.Motion is { } motion)
        {
            numbers.AddRange([motion.YawRate, motion.Acceleration]);
            if (motion is { Steering: { } steering, Throttle: { } throttle, Brake: { } brake })
            {
                numbers.AddRange([steering, throttle, brake]);
            }
        }

        return string.Join(
            ' ',
            numbers
                .Select(number => number.ToString("R", CultureInfo.InvariantCulture))
                .Prepend(timestampOf(sample.TimeSeconds).ToString(CultureInfo.InvariantCulture))
        );
    }

    /// <summary>Reads the parts of a scene, each an area and rows. Positions are moved into the global frame of the scene.</summary>
    public static NuScenesRide Read(IEnumerable<string> lines)
    {
        var samples = new List<MotionSample>();
        var places = new List<(long Timestamp, Vector3D Place)>();
        string[][] parts = [.. lines.Select(line => line.Split(Separator))];
        Vector3D offset = NuScenesArea.Of(parts.Select(part => NuScenesArea.Parse(part[0]))).Offset;
        foreach (string[] words in parts.SelectMany(part => part.Skip(1)).Select(row => row.Split(' ')))
        {
            double[] row = Numbers.Parse(words.Skip(1))!;
            samples.Add(new MotionSample(row[0], At(row, 1), At(row, 7), At(row, 10), At(row, 13), MotionOf(row)));
            places.Add((long.Parse(words[0], CultureInfo.InvariantCulture), At(row, 4) + offset));
        }

        return new NuScenesRide([
            .. EgoTrack.Of(samples).Zip(places, (reading, place) => new NuScenesMoment(place.Timestamp, reading, place.Place)),
        ]);
    }

    /// <summary>The first tick of each period.</summary>
    public IEnumerable<NuScenesMoment> Every(double seconds)
    {
        double next = double.NegativeInfinity;
        foreach (NuScenesMoment moment in All.Where(moment => moment.Reading.TimeSeconds >= next))
        {
            next = moment.Reading.TimeSeconds + seconds - 1e-6;
            yield return moment;
        }
    }

    /// <summary>The way that was driven, a point for each metre.</summary>
    public IEnumerable<Vector3D> Route()
    {
        Vector3D? last = null;
        foreach (Vector3D place in All.Select(moment => moment.Position))
        {
            if (last is not { } before || (place - before).Length >= RouteStep)
            {
                last = place;
                yield return place;
            }
        }
    }

    private static EgoMotion? MotionOf(double[] row) =>
        row.Length <= 16 ? null
        : row.Length <= 18 ? new EgoMotion(row[16], row[17])
        : new EgoMotion(row[16], row[17])
        {
            Steering = row[18],
            Throttle = row[19],
            Brake = row[20],
        };

    private static double[] Of(Vector3D vector) => [vector.X, vector.Y, vector.Z];

    private static Vector3D At(double[] row, int index) => new(row[index], row[index + 1], row[index + 2]);
}
