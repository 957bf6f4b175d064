using System.Globalization;
using Harvester.Geometry;

namespace Harvester.Sessions.Faces;

/// <summary>The two corners given by a row of a table, or what is wrong with them.</summary>
internal readonly struct FaceCorners
{
    /// <summary>A corner farther from its model's origin than this is a mistake, metres.</summary>
    private const double MaxCoordinate = 100;
    private const int Axes = 3;

    private FaceCorners(Vector3D frontUpperLeft, Vector3D backLowerRight, (string Column, string Reason)? problem)
    {
        FrontUpperLeft = frontUpperLeft;
        BackLowerRight = backLowerRight;
        Problem = problem;
    }

    public Vector3D FrontUpperLeft { get; }

    public Vector3D BackLowerRight { get; }

    public (string Column, string Reason)? Problem { get; }

    /// <summary>Parses the fields of a row.</summary>
    public static FaceCorners Parse(List<string> fields)
    {
        var corner = new double[2 * Axes];
        for (int i = 0; i < corner.Length; i++)
        {
            string field = fields[FaceColumns.FirstCorner + i];
            if (
                !double.TryParse(field, NumberStyles.Float, CultureInfo.InvariantCulture, out corner[i])
                || !(Math.Abs(corner[i]) <= MaxCoordinate)
            )
            {
                return new FaceCorners(
                    default,
                    default,
                    (NameOf(i), $"'{field}' is not a number from -100 to 100 (metres, with a decimal point).")
                );
            }
        }

        (bool IsRight, string Rule)[] axes =
        [
            (corner[0] < corner[3], "less than"),
            (corner[1] >= corner[4], "not less than"),
            (corner[2] > corner[5], "greater than"),
        ];
        int[] wrong = [.. Enumerable.Range(0, Axes).Where(axis => !axes[axis].IsRight)];
        return wrong.Length == 0
            ? new FaceCorners(new Vector3D(corner[0], corner[1], corner[2]), new Vector3D(corner[3], corner[4], corner[5]), null)
            : new FaceCorners(
                default,
                default,
                (
                    string.Join(", ", wrong.Select(axis => $"{NameOf(axis)}, {NameOf(axis + Axes)}")),
                    $"the cuboid is inside out: {string.Join(", ", wrong.Select(axis => RuleOf(axis, axes[axis].Rule)))}."
                )
            );
    }

    private static string RuleOf(int axis, string rule) => $"{NameOf(axis)} must be {rule} {NameOf(axis + Axes)}";

    private static string NameOf(int corner) => FaceColumns.Names[FaceColumns.FirstCorner + corner];
}
