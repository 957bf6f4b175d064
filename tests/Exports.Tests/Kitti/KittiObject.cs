using System.Globalization;
using Harvester.Geometry;

namespace Harvester.Exports.Tests.Kitti;

/// <summary>An object of KITTI's label_2, read as the development kit's readme describes it.</summary>
internal sealed record KittiObject(
    string Type,
    double Truncated,
    int Occluded,
    double Alpha,
    Box2D Box,
    double Height,
    double Width,
    double Length,
    Vector3D Location,
    double RotationY
)
{
    public static KittiObject[] ReadAll(string path) => [.. File.ReadAllLines(path).Select(Parse)];

    /// <summary>The matrix of a name in a calibration file, 3 x 4.</summary>
    public static double[] ReadMatrix(string path, string name) =>
        [
            .. File.ReadAllLines(path)
                .Single(line => line.StartsWith(name + ": ", StringComparison.Ordinal))
                .Split(' ')
                .Skip(1)
                .Select(Number),
        ];

    /// <summary>
    /// The box around the eight projected corners: x = P2 · (R(rotation_y) · corner + location), as the kit's computeBox3D does it.
    /// </summary>
    public Box2D Project(double[] p2)
    {
        double cos = Math.Cos(RotationY);
        double sin = Math.Sin(RotationY);
        var points = new List<Vector2D>();
        foreach (double along in (double[])[-Length / 2, Length / 2])
        {
            foreach (double up in (double[])[0, -Height])
            {
                foreach (double across in (double[])[-Width / 2, Width / 2])
                {
                    double x = (cos * along) + (sin * across) + Location.X;
                    double y = up + Location.Y;
                    double z = (-sin * along) + (cos * across) + Location.Z;
                    double w = (p2[8] * x) + (p2[9] * y) + (p2[10] * z) + p2[11];
                    points.Add(
                        new Vector2D(
                            ((p2[0] * x) + (p2[1] * y) + (p2[2] * z) + p2[3]) / w,
                            ((p2[4] * x) + (p2[5] * y) + (p2[6] * z) + p2[7]) / w
                        )
                    );
                }
            }
        }

        return new Box2D(points.Min(p => p.X), points.Min(p => p.Y), points.Max(p => p.X), points.Max(p => p.Y));
    }

    private static KittiObject Parse(string line)
    {
        string[] words = line.Split(' ');
        Assert.Equal(15, words.Length);
        double[] n = [.. words.Skip(1).Select(Number)];
        return new KittiObject(
            words[0],
            n[0],
            int.Parse(words[2], CultureInfo.InvariantCulture),
            n[2],
            new Box2D(n[3], n[4], n[5], n[6]),
            n[7],
            n[8],
            n[9],
            new Vector3D(n[10], n[11], n[12]),
            n[13]
        );
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
