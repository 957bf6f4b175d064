using Harvester.Geometry;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>
/// Checks what the poses, boxes and points of a nuScenes dataset say of each other: every box is in an image of its sample, has the
/// points that are counted, and moves the way it faces.
/// </summary>
/// <param name="dataset">The dataset.</param>
/// <param name="tables">Its tables, by name and token.</param>
internal sealed class NuScenesGeometryCheck(DatasetContent dataset, IReadOnlyDictionary<string, Dictionary<string, JsonFields>> tables)
{
    /// <summary>x, y, z, intensity and ring, float32 each.</summary>
    private const int BytesPerPoint = 20;

    /// <summary>Quaternions have nine decimals.</summary>
    private const double RoundingUnit = 1e-6;

    /// <summary>Boxes have four decimals of a metre, which are less than this in the image of a camera at 0.1 m.</summary>
    private const double RoundingPixels = 2;

    /// <summary>Nothing nearer to a camera is drawn, metres.</summary>
    private const double NearMetres = 0.1;

    /// <summary>Traffic does not reverse as fast, m/s.</summary>
    private const double MaxReverse = 8;

    /// <summary>Boxes that lean by more than 60 degrees have an up axis with a vertical part below its cosine.</summary>
    private const double LeaningCosine = 0.5;

    /// <summary>A vehicle may lie on its side; where more than this fraction of the boxes does, their rotations are wrong.</summary>
    private const double MaxLeaningFraction = 1 / 3.0;

    private const double Microseconds = 1e6;

    private readonly ILookup<string, JsonFields> _annotations = tables["sample_annotation"]
        .Values.ToLookup(record => record.Text("sample_token"));

    /// <summary>The problem of the orientation and intrinsics of a pose or a sensor.</summary>
    public static string? PoseProblem(JsonFields record)
    {
        _ = record.Numbers("translation", 3);
        return Math.Abs(record.Numbers("rotation", 4).Sum(part => part * part) - 1) > RoundingUnit
            ? "its rotation is no unit quaternion."
            : null;
    }

    /// <summary>The problem of the rotations of all boxes: with the scalar last, most of them lie on their sides or heads.</summary>
    public string? LeaningProblem()
    {
        int boxes = tables["sample_annotation"].Count;
        int leaning = tables["sample_annotation"].Values.Count(record => new NuScenesBox(record).Up.Z < LeaningCosine);
        return leaning > MaxLeaningFraction * boxes
            ? FormattableString.Invariant($"{leaning} of {boxes} boxes lean by more than 60 degrees: rotation is w, x, y, z.")
            : null;
    }

    /// <summary>The problem of the boxes of a sample; each is the first of its kind.</summary>
    /// <param name="sample">The token of the sample.</param>
    /// <param name="data">The key frames of its sensors.</param>
    public IEnumerable<string> Problems(string sample, IReadOnlyList<JsonFields> data)
    {
        JsonFields[] cameras = [.. data.Where(record => record.Integer("width") > 0)];
        var points = new List<Vector3D>();
        foreach (JsonFields scan in data.Where(record => record.Integer("width") == 0))
        {
            if (!NuScenesSensor.IsRadar(scan.Text("filename")))
            {
                points.AddRange(PointsOf(scan));
            }
            else if (RadarProblem(scan.Text("filename")) is { } problem)
            {
                yield return problem;
            }
        }

        foreach (JsonFields annotation in _annotations[sample])
        {
            var box = new NuScenesBox(annotation);
            string? problem =
                !cameras.Any(camera => Shows(camera, box)) ? "its box is in no image of its sample."
                : box.Count(points) is var inside && inside != annotation.Integer("num_lidar_pts")
                    ? FormattableString.Invariant(
                        $"num_lidar_pts is {annotation.Integer("num_lidar_pts")}, and {inside} points are inside its box."
                    )
                : ShapeProblem(annotation) ?? MotionProblem(annotation, box);
            if (problem is not null)
            {
                yield return $"{annotation.Text("token")}: {problem}";
            }
        }
    }

    /// <summary>Whether the corners of a box are not all beyond the same side of a camera's image, or behind the camera.</summary>
    private bool Shows(JsonFields camera, NuScenesBox box)
    {
        JsonFields sensor = tables["calibrated_sensor"][camera.Text("calibrated_sensor_token")];
        var toEgo = new NuScenesMotion(sensor);
        var toGlobal = new NuScenesMotion(tables["ego_pose"][camera.Text("ego_pose_token")]);
        double[][] k = sensor.Rows("camera_intrinsic", 3);
        double width = camera.Integer("width") + RoundingPixels;
        double height = camera.Integer("height") + RoundingPixels;
        Vector3D[] corners = [.. box.Corners.Select(corner => toEgo.Invert(toGlobal.Invert(corner)))];

        // A side of the image and the camera span a plane: u = fx x / z + cx is less than 0 where fx x + cx z is, for z above 0.
        return corners.Any(c => c.Z >= NearMetres)
            && corners.Any(c => (k[0][0] * c.X) + ((k[0][2] + RoundingPixels) * c.Z) >= 0)
            && corners.Any(c => (k[0][0] * c.X) + ((k[0][2] - width) * c.Z) <= 0)
            && corners.Any(c => (k[1][1] * c.Y) + ((k[1][2] + RoundingPixels) * c.Z) >= 0)
            && corners.Any(c => (k[1][1] * c.Y) + ((k[1][2] - height) * c.Z) <= 0);
    }

    private IEnumerable<Vector3D> PointsOf(JsonFields scan)
    {
        var toEgo = new NuScenesMotion(tables["calibrated_sensor"][scan.Text("calibrated_sensor_token")]);
        var toGlobal = new NuScenesMotion(tables["ego_pose"][scan.Text("ego_pose_token")]);
        byte[] bytes = InputFile.ReadAllBytes(dataset.PathOf(scan.Text("filename")), LidarFile.MaxPoints * BytesPerPoint);
        for (int at = 0; at + BytesPerPoint <= bytes.Length; at += BytesPerPoint)
        {
            yield return toGlobal.Apply(
                toEgo.Apply(
                    new Vector3D(
                        BitConverter.ToSingle(bytes, at),
                        BitConverter.ToSingle(bytes, at + 4),
                        BitConverter.ToSingle(bytes, at + 8)
                    )
                )
            );
        }
    }

    private string? RadarProblem(string file)
    {
        byte[] content = InputFile.ReadAllBytes(dataset.PathOf(file), NuScenesRadar.MaxBytes);
        return NuScenesRadar.IsWhole(content) ? null : $"{file} does not have the header of a radar and the points that it counts.";
    }

    private string? ShapeProblem(JsonFields annotation)
    {
        double[] size = annotation.Numbers("size", 3);
        return IsVehicle(annotation) && size[0] > size[1] ? "the vehicle is wider than long: size is width, length, height." : null;
    }

    private string? MotionProblem(JsonFields annotation, NuScenesBox box)
    {
        if (!IsVehicle(annotation) || !tables["sample_annotation"].TryGetValue(annotation.Text("next"), out JsonFields next))
        {
            return null;
        }

        double seconds = (TimeOf(next) - TimeOf(annotation)) / Microseconds;
        Vector3D way = new NuScenesBox(next).Centre - box.Centre;
        return seconds > 0 && way.Dot(box.Forward) / seconds < -MaxReverse
            ? $"the vehicle moves backwards at more than {MaxReverse} m/s."
            : null;
    }

    private double TimeOf(JsonFields annotation) => tables["sample"][annotation.Text("sample_token")].LongInteger("timestamp");

    private bool IsVehicle(JsonFields annotation)
    {
        JsonFields instance = tables["instance"][annotation.Text("instance_token")];
        return tables["category"][instance.Text("category_token")].Text("name").StartsWith("vehicle.", StringComparison.Ordinal);
    }
}
