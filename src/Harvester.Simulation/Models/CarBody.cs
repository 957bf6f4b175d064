using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>
/// The lower body of a car: cross-sections along its length, narrower at both ends, cut out around the wheels. The bumpers reach the ends
/// of the box, the mirrors its sides.
/// </summary>
internal sealed class CarBody(ModelFrame frame, CarProfile profile, MeshBuilder builder, Rgb colour)
{
    /// <summary>Distance of the body from the box's sides and ends, as a fraction of width and length.</summary>
    public const double Inset = 0.012;

    private const double BedWall = 0.035;
    private const double BedFloor = 0.36;
    private const int ArchSteps = 6;
    private const double ArchClearance = 1.13;

    private double WheelRadius => profile.WheelRadius * frame.Height;

    public void Add()
    {
        List<double> stations = Stations();
        for (int i = 1; i < stations.Count; i++)
        {
            AddSection(stations[i - 1], stations[i]);
        }

        AddEnd(Inset);
        AddEnd(1 - Inset);
        AddUnderbody();
        AddBumpers();
        AddDoorGaps();
        if (profile.HasBed)
        {
            AddBed();
        }
    }

    /// <summary>Height of the body's upper edge at a position along the car.</summary>
    public double DeckAt(double forward)
    {
        (double At, double Height)[] edge =
        [
            (Inset, profile.Tail - 0.03),
            (0.03, profile.Tail),
            (profile.CabinRear, profile.HasBed ? profile.Tail : profile.Belt),
            (profile.CabinRear + 0.001, profile.Belt),
            (profile.CabinFront, profile.Belt),
            (0.95, profile.Nose),
            (1 - Inset, profile.Nose - 0.06),
        ];
        int after = Array.FindIndex(edge, point => point.At >= forward);
        if (after <= 0)
        {
            return edge[after < 0 ? ^1 : 0].Height;
        }

        (double at0, double height0) = edge[after - 1];
        (double at1, double height1) = edge[after];
        return height0 + ((height1 - height0) * (forward - at0) / Math.Max(at1 - at0, 1e-9));
    }

    /// <summary>Half the body's width at a position along the car, as a fraction of the box's width.</summary>
    public double HalfWidthAt(double forward)
    {
        const double straight = 0.34;
        double beyond = Math.Max(0, Math.Abs(forward - 0.5) - straight) / (0.5 - straight);
        return 0.5 - Inset - (profile.Taper * beyond * beyond);
    }

    private List<double> Stations()
    {
        SortedSet<double> stations = [Inset, 0.03, 0.95, 1 - Inset, profile.CabinFront, (profile.CabinFront + 0.95) / 2];
        if (profile.CabinRear > 0.03)
        {
            stations.UnionWith([profile.CabinRear, profile.CabinRear + 0.001]);
        }

        foreach (double axle in new[] { profile.RearAxle, profile.FrontAxle })
        {
            for (int step = 0; step <= ArchSteps; step++)
            {
                stations.Add(axle - (ArchClearance * WheelRadius / frame.Length * Math.Cos(Math.PI * step / ArchSteps)));
            }
        }

        return [.. stations.Where(station => station is >= Inset and <= 1 - Inset)];
    }

    /// <summary>Height of the lower edge, metres: the sill, or the arch over a wheel.</summary>
    private double LowerEdgeAt(double forward)
    {
        double sill = frame.Z(profile.Sill);
        double hub = frame.Min.Z + WheelRadius;
        foreach (double axle in new[] { profile.RearAxle, profile.FrontAxle })
        {
            double along = (forward - axle) * frame.Length;
            double squared = (ArchClearance * ArchClearance * WheelRadius * WheelRadius) - (along * along);
            sill = squared > 0 ? Math.Max(sill, hub + Math.Sqrt(squared)) : sill;
        }

        return Math.Min(sill, frame.Z(DeckAt(forward)) - 0.02);
    }

    private (Vector3D Low, Vector3D Middle, Vector3D High) EdgeAt(double forward, int side)
    {
        double low = LowerEdgeAt(forward);
        double high = frame.Z(DeckAt(forward));
        double middle = low + ((high - low) * 0.62);
        double half = HalfWidthAt(forward);
        Vector3D Point(double share, double height) => new(frame.X(0.5 + (side * half * share)), frame.Y(forward), height);
        return (Point(0.985, low), Point(1, middle), Point(0.93, high));
    }

    private void AddSection(double from, double to)
    {
        foreach (int side in new[] { -1, 1 })
        {
            (Vector3D low0, Vector3D middle0, Vector3D high0) = EdgeAt(from, side);
            (Vector3D low1, Vector3D middle1, Vector3D high1) = EdgeAt(to, side);
            builder.AddQuad(low0, low1, middle1, middle0, colour.Scaled(0.94), Surface.Paint);
            builder.AddQuad(middle0, middle1, high1, high0, colour, Surface.Paint);
        }

        if (!profile.HasBed || to > profile.CabinRear || from < BedWall - 0.01)
        {
            Vector3D left0 = EdgeAt(from, -1).High;
            Vector3D left1 = EdgeAt(to, -1).High;
            builder.AddQuad(left0, left1, EdgeAt(to, 1).High, EdgeAt(from, 1).High, colour, Surface.Paint);
        }
    }

    private void AddEnd(double forward)
    {
        (Vector3D low0, Vector3D middle0, Vector3D high0) = EdgeAt(forward, -1);
        (Vector3D low1, Vector3D middle1, Vector3D high1) = EdgeAt(forward, 1);
        builder.AddPolygon([low0, middle0, high0, high1, middle1, low1], colour, Surface.Paint);
    }

    private void AddUnderbody()
    {
        double top = Math.Min(profile.Nose, profile.Tail) - 0.1;
        builder.AddBox(
            frame.At(0.15, 0.03, profile.Sill * 0.75),
            frame.At(0.85, 0.97, Math.Max(top, profile.Sill + 0.05)),
            VehiclePaint.DarkPlastic
        );
        builder.AddBox(
            frame.At(0.04, profile.RearAxle + 0.09, profile.Sill * 0.8),
            frame.At(0.96, profile.FrontAxle - 0.09, profile.Sill + 0.02),
            VehiclePaint.DarkPlastic
        );
    }

    private void AddBumpers()
    {
        double low = profile.Sill * 0.45;
        const double high = 0.3;
        Rgb shade = profile.Sill > 0.15 ? VehiclePaint.DarkPlastic : colour.Scaled(0.85);
        foreach ((double face, double rib, double inner) in new[] { (0.005, 0.0, 0.05), (0.995, 1.0, 0.95) })
        {
            double half = HalfWidthAt(face);
            builder.AddBox(
                frame.At(0.5 - half, Math.Min(face, inner), low),
                frame.At(0.5 + half, Math.Max(face, inner), high),
                shade,
                Surface.Paint
            );
            builder.AddBox(
                frame.At(0.5 - half, Math.Min(rib, inner), high - 0.05),
                frame.At(0.5 + half, Math.Max(rib, inner), high),
                shade,
                Surface.Paint
            );
        }

        builder.AddBox(frame.At(0.28, 0.98, profile.Sill + 0.02), frame.At(0.72, 0.9965, high - 0.07), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.41, 0.003, profile.Sill + 0.03), frame.At(0.59, 0.02, high - 0.065), VehiclePaint.Plate);
        builder.AddBox(frame.At(0.30, 0.97, profile.Nose - 0.135), frame.At(0.70, 0.9915, profile.Nose - 0.07), VehiclePaint.DarkPlastic);
    }

    /// <summary>Adds the gaps of the doors as dark lines on both sides.</summary>
    private void AddDoorGaps()
    {
        const double proud = 0.004;
        foreach ((double from, double to) in profile.Windows)
        {
            foreach (double share in new[] { from, to })
            {
                double forward = profile.CabinRear + ((profile.CabinFront - profile.CabinRear) * share);
                if (Math.Abs(forward - profile.RearAxle) < 0.09 || Math.Abs(forward - profile.FrontAxle) < 0.09)
                {
                    continue;
                }

                foreach (int side in new[] { -1, 1 })
                {
                    (Vector3D low, Vector3D middle, Vector3D high) = EdgeAt(forward, side);
                    Vector3D out0 = new(side * proud, 0, 0);
                    Vector3D breadth = new(0, 0.014, 0);
                    builder.AddQuad(low + out0, low + out0 + breadth, middle + out0 + breadth, middle + out0, VehiclePaint.DarkPlastic);
                    builder.AddQuad(middle + out0, middle + out0 + breadth, high + out0 + breadth, high + out0, VehiclePaint.DarkPlastic);
                }
            }
        }
    }

    private void AddBed()
    {
        double front = profile.CabinRear - 0.01;
        double half = HalfWidthAt(0.3) * 0.93;
        double left = 0.5 - half;
        Vector3D At(double right, double forward, double up) => frame.At(right, forward, up);
        builder.AddBox(At(left + BedWall, BedWall, BedFloor - 0.02), At(1 - left - BedWall, front, BedFloor), VehiclePaint.DarkPlastic);
        builder.AddBox(At(left + 0.004, BedWall, BedFloor), At(left + BedWall, front, profile.Tail), colour.Scaled(0.9), Surface.Paint);
        builder.AddBox(
            At(1 - left - BedWall, BedWall, BedFloor),
            At(1 - left - 0.004, front, profile.Tail),
            colour.Scaled(0.9),
            Surface.Paint
        );
        builder.AddBox(At(left, 0.02, BedFloor), At(1 - left, BedWall, profile.Tail), colour.Scaled(0.95), Surface.Paint);
        builder.AddBox(At(left, front, BedFloor), At(1 - left, front + 0.01, profile.Tail), colour, Surface.Paint);
    }
}
