using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>The part of a car above its belt line: a painted shell with panes on it, so that the pillars stay between them.</summary>
internal sealed class CarCabin(ModelFrame frame, CarProfile profile, MeshBuilder builder, Rgb colour)
{
    private const double RoofLine = 0.945;
    private const double BeltInset = 0.035;
    private const double PaneBottom = 0.02;
    private const double PaneTop = 0.93;

    public void Add()
    {
        Vector3D low = frame.At(BeltInset, profile.CabinRear, profile.Belt - 0.01);
        Vector3D high = frame.At(1 - BeltInset, profile.CabinFront, RoofLine);
        Vector3D roofLow = frame.At(profile.RoofInset, profile.RoofRear, RoofLine);
        Vector3D roofHigh = frame.At(1 - profile.RoofInset, profile.RoofFront, RoofLine);
        builder.AddFrustum(low, high, roofLow, roofHigh, colour, Surface.Paint);
        builder.AddFrustum(
            roofLow,
            roofHigh with
            {
                Z = frame.Max.Z,
            },
            frame.At(profile.RoofInset + 0.03, profile.RoofRear + 0.015, 1),
            frame.At(1 - profile.RoofInset - 0.03, profile.RoofFront - 0.02, 1),
            colour,
            Surface.Paint
        );
        foreach (int side in new[] { -1, 1 })
        {
            foreach ((double from, double to) in profile.Windows)
            {
                AddPane(
                    new(side, 0, 0),
                    SidePoint(side, from, PaneBottom),
                    SidePoint(side, to, PaneBottom),
                    SidePoint(side, to, PaneTop),
                    SidePoint(side, from, PaneTop)
                );
            }
        }

        AddPane(
            new(0, 1, 0),
            EndPoint(true, 0.03, PaneBottom),
            EndPoint(true, 0.97, PaneBottom),
            EndPoint(true, 0.94, PaneTop),
            EndPoint(true, 0.06, PaneTop)
        );
        if (profile.HasRearWindow)
        {
            AddPane(
                new(0, -1, 0),
                EndPoint(false, 0.08, 0.1),
                EndPoint(false, 0.92, 0.1),
                EndPoint(false, 0.9, PaneTop),
                EndPoint(false, 0.1, PaneTop)
            );
        }
        else
        {
            AddPane(
                new(0, -1, 0),
                EndPoint(false, 0.1, 0.3),
                EndPoint(false, 0.46, 0.3),
                EndPoint(false, 0.46, 0.88),
                EndPoint(false, 0.1, 0.88)
            );
            AddPane(
                new(0, -1, 0),
                EndPoint(false, 0.54, 0.3),
                EndPoint(false, 0.9, 0.3),
                EndPoint(false, 0.9, 0.88),
                EndPoint(false, 0.54, 0.88)
            );
        }
    }

    /// <summary>A point of a side: a share of the way from the rear end to the front, and of the height above the belt.</summary>
    private Vector3D SidePoint(int side, double along, double up)
    {
        double bottom = profile.CabinRear + ((profile.CabinFront - profile.CabinRear) * along);
        double top = profile.RoofRear + ((profile.RoofFront - profile.RoofRear) * along);
        double inset = BeltInset + ((profile.RoofInset - BeltInset) * up);
        return frame.At(side < 0 ? inset : 1 - inset, bottom + ((top - bottom) * up), Height(up));
    }

    private Vector3D EndPoint(bool front, double across, double up)
    {
        double bottom = front ? profile.CabinFront : profile.CabinRear;
        double top = front ? profile.RoofFront : profile.RoofRear;
        double inset = BeltInset + ((profile.RoofInset - BeltInset) * up);
        return frame.At(inset + ((1 - (2 * inset)) * across), bottom + ((top - bottom) * up), Height(up));
    }

    private double Height(double up) => profile.Belt - 0.01 + ((RoofLine - profile.Belt + 0.01) * up);

    private void AddPane(Vector3D outward, Vector3D a, Vector3D b, Vector3D c, Vector3D d) =>
        VehicleParts.AddPane(builder, outward, a, b, c, d, VehiclePaint.Window, Surface.Glass);
}
