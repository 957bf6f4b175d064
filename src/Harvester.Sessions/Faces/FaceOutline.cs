using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Faces;

/// <summary>
/// The shape of a face within its cuboid. Seen at an angle, the near edge of a cuboid is longer than that of the octagon or diamond in it,
/// by several pixels at a few metres; therefore boxes are computed from the shape. It follows from the sign's code: the Manual on Uniform
/// Traffic Control Devices reserves the octagon for R1-1, the triangle on its tip for R1-2, and the diamond for the warnings W.
/// </summary>
public static class FaceOutline
{
    /// <summary>Position of an octagon's corners along a side of the square around it: (1 - tan 22.5°) / 2.</summary>
    private const double OctagonCut = 0.29289321881345248;

    /// <summary>The shape of a face; a rectangle if nothing else is known.</summary>
    public static SignShape ShapeOf(ModelFace face)
    {
        if (face is null)
        {
            throw new ArgumentNullException(nameof(face));
        }

        return face switch
        {
            { Class: not ObjectClass.Sign } => SignShape.Rectangle,
            { MutcdCode: "R1-1" } => SignShape.Octagon,
            { MutcdCode: "R1-2" } => SignShape.Triangle,
            { MutcdCode: { Length: > 0 } code } when code[0] == 'W' => SignShape.Diamond,
            _ => SignShape.Rectangle,
        };
    }

    /// <summary>The edges of a face's body in the world: its outline at the front, at the back, and the edges between them.</summary>
    /// <param name="face">The face.</param>
    /// <param name="entity">Pose of the entity that has it.</param>
    public static IEnumerable<(Vector3D Start, Vector3D End)> EdgesOf(ModelFace face, Pose entity)
    {
        (double Across, double Up)[] outline = Outline(ShapeOf(face));
        for (int i = 0; i < outline.Length; i++)
        {
            (double Across, double Up) next = outline[(i + 1) % outline.Length];
            Vector3D front = At(outline[i], 1);
            Vector3D back = At(outline[i], 0);
            yield return (front, At(next, 1));
            yield return (back, At(next, 0));
            yield return (front, back);
        }

        Vector3D At((double Across, double Up) corner, double deep)
        {
            Vector3D left = face.FrontUpperLeft;
            Vector3D right = face.BackLowerRight;
            bool isAcrossX = face.Facing is Facing.Back or Facing.Front;
            return entity.ToWorld(
                new Vector3D(
                    Between(left.X, right.X, isAcrossX ? corner.Across : deep),
                    Between(right.Y, left.Y, isAcrossX ? deep : corner.Across),
                    Between(right.Z, left.Z, corner.Up)
                )
            );
        }
    }

    /// <summary>Corners in order, as fractions of the rectangle's width and height.</summary>
    private static (double Across, double Up)[] Outline(SignShape shape) =>
        shape switch
        {
            SignShape.Octagon =>
            [
                (OctagonCut, 0),
                (1 - OctagonCut, 0),
                (1, OctagonCut),
                (1, 1 - OctagonCut),
                (1 - OctagonCut, 1),
                (OctagonCut, 1),
                (0, 1 - OctagonCut),
                (0, OctagonCut),
            ],
            SignShape.Triangle => [(0.5, 0), (1, 1), (0, 1)],
            SignShape.Diamond => [(0.5, 0), (1, 0.5), (0.5, 1), (0, 0.5)],
            _ => [(0, 0), (1, 0), (1, 1), (0, 1)],
        };

    private static double Between(double from, double to, double share) => from + ((to - from) * share);
}
