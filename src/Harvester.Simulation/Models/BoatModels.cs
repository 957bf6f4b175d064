using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Motor boats on land, on a cradle: a hull with a keel, a windscreen, a canopy on posts and an outboard engine.</summary>
internal static class BoatModels
{
    private const double Gunwale = 0.48;
    private static readonly Rgb Cloth = new(232, 230, 222);
    private static readonly Rgb Wood = new(150, 116, 78);

    public static Mesh Build(VehicleRow row, Rgb colour)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        var builder = new MeshBuilder();
        (double At, double Half, double Keel)[] ribs =
        [
            (0.06, 0.44, 0.06),
            (0.3, 0.5, 0),
            (0.6, 0.48, 0),
            (0.82, 0.3, 0.06),
            (1, 0.01, 0.34),
        ];
        for (int i = 1; i < ribs.Length; i++)
        {
            AddSection(builder, frame, ribs[i - 1], ribs[i], colour);
        }

        builder.AddPolygon(
            [Rib(frame, ribs[0], -1, 0.92), Rib(frame, ribs[0], -1, 0), Rib(frame, ribs[0], 1, 0), Rib(frame, ribs[0], 1, 0.92)],
            colour,
            Surface.Paint
        );
        foreach (double beam in new[] { 0.28, 0.58 })
        {
            builder.AddBox(frame.At(0.12, beam, 0), frame.At(0.88, beam + 0.03, 0.035), Wood);
            builder.AddBox(frame.At(0.14, beam, 0.035), frame.At(0.2, beam + 0.03, 0.2), Wood);
            builder.AddBox(frame.At(0.8, beam, 0.035), frame.At(0.86, beam + 0.03, 0.2), Wood);
        }

        builder.AddBox(frame.At(0.42, 0, 0.16), frame.At(0.58, 0.07, 0.6), VehiclePaint.DarkPlastic, Surface.Paint);
        builder.AddFrustum(
            frame.At(0.2, 0.5, Gunwale),
            frame.At(0.8, 0.64, 0.66),
            frame.At(0.24, 0.5, 0),
            frame.At(0.76, 0.54, 0),
            VehiclePaint.Window,
            Surface.Glass
        );
        builder.AddBox(frame.At(0.36, 0.36, Gunwale - 0.02), frame.At(0.64, 0.46, 0.62), Cloth);
        builder.AddBox(frame.At(0.14, 0.2, Gunwale - 0.02), frame.At(0.86, 0.28, 0.55), Cloth);
        builder.AddBox(frame.At(0.14, 0.26, 0.975), frame.At(0.86, 0.6, 1), Cloth);
        foreach (double left in new[] { 0.16, 0.82 })
        {
            builder.AddBox(frame.At(left, 0.28, Gunwale), frame.At(left + 0.02, 0.29, 0.975), VehiclePaint.Rim);
            builder.AddBox(frame.At(left, 0.56, Gunwale), frame.At(left + 0.02, 0.57, 0.975), VehiclePaint.Rim);
        }

        return builder.Build();
    }

    private static void AddSection(
        MeshBuilder builder,
        ModelFrame frame,
        (double At, double Half, double Keel) rear,
        (double At, double Half, double Keel) front,
        Rgb colour
    )
    {
        foreach (int side in new[] { -1, 1 })
        {
            builder.AddQuad(
                Rib(frame, rear, side, 0),
                Rib(frame, front, side, 0),
                Rib(frame, front, side, 0.92),
                Rib(frame, rear, side, 0.92),
                colour,
                Surface.Paint
            );
            builder.AddQuad(
                Rib(frame, rear, side, 0.92),
                Rib(frame, front, side, 0.92),
                Rib(frame, front, side, 1),
                Rib(frame, rear, side, 1),
                Cloth,
                Surface.Paint
            );
            builder.AddQuad(
                Keel(frame, rear),
                Keel(frame, front),
                Rib(frame, front, side, 0),
                Rib(frame, rear, side, 0),
                colour.Scaled(0.5)
            );
        }

        builder.AddQuad(
            Rib(frame, rear, -1, 0.94),
            Rib(frame, front, -1, 0.94),
            Rib(frame, front, 1, 0.94),
            Rib(frame, rear, 1, 0.94),
            front.At > 0.7 ? Cloth : Wood
        );
    }

    /// <summary>A point of the hull's side: 0 at the chine, 1 at the gunwale.</summary>
    private static Vector3D Rib(ModelFrame frame, (double At, double Half, double Keel) rib, int side, double up)
    {
        double chine = rib.Keel + 0.14;
        double half = rib.Half * (0.72 + (0.28 * up));
        return frame.At(0.5 + (side * half), rib.At, chine + ((Gunwale - chine) * up));
    }

    private static Vector3D Keel(ModelFrame frame, (double At, double Half, double Keel) rib) => frame.At(0.5, rib.At, rib.Keel);
}
