using Harvester.Geometry;

namespace Harvester.Simulation.Models;

/// <summary>Where the lamps of a vehicle are. All lie at least <see cref="Glow"/> within the model's box.</summary>
internal static class VehicleLampLayout
{
    /// <summary>The light of a lamp that is on is drawn this far around its glass, metres.</summary>
    public const double Glow = 0.003;

    /// <summary>Distance of the glasses on heavy vehicles and two-wheelers from the ends of the box, metres.</summary>
    private const double FromEnd = 0.006;
    private const double Depth = 0.05;

    public static IReadOnlyList<VehicleLamp> Of(VehicleRow row)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        List<VehicleLamp> lamps = [];
        switch (row.Shape)
        {
            case VehicleShape.Boat:
                break;
            case VehicleShape.Bicycle:
                lamps.Add(Middle(LampKind.Head, frame, 0.44, 0.56, frame.Y(0.735), 0.94, 0.99));
                lamps.Add(Middle(LampKind.Tail, frame, 0.44, 0.56, frame.Y(0.27), 0.72, 0.78));
                break;
            case VehicleShape.Motorcycle or VehicleShape.Chopper:
                AddMotorcycle(lamps, frame, row.Shape == VehicleShape.Chopper);
                break;
            case VehicleShape.Bus:
                AddFront(lamps, frame, 0.06, 0.2, 0.19, 0.28, 0.05);
                AddRear(lamps, frame, 0.05, 0.13, 0.3, 0.38, 0.05, above: true);
                lamps.Add(Middle(LampKind.HighBrake, frame, 0.42, 0.58, frame.Min.Y + FromEnd, 0.88, 0.9));
                break;
            case VehicleShape.Trailer or VehicleShape.Tanker or VehicleShape.LogTrailer:
                AddRear(lamps, frame, 0.05, 0.17, 0.17, 0.215, 0.06, above: false);
                break;
            case VehicleShape.Tractor:
                AddFront(lamps, frame, 0.16, 0.28, 0.2, 0.26, 0.05);
                AddRear(lamps, frame, 0.2, 0.3, 0.15, 0.19, 0.05, above: false);
                break;
            case VehicleShape.BoxTruck or VehicleShape.DumpTruck or VehicleShape.BoxVan:
                AddFront(lamps, frame, 0.07, 0.22, 0.16, 0.23, 0.05);
                AddRear(lamps, frame, 0.05, 0.17, 0.11, 0.16, 0.05, above: false);
                break;
            default:
                AddCar(lamps, frame, row.Shape);
                break;
        }

        return lamps;
    }

    private static void AddCar(List<VehicleLamp> lamps, ModelFrame frame, VehicleShape shape)
    {
        CarProfile profile = CarProfile.Of(shape);
        double outer = 0.008 + profile.Taper + CarBody.Inset;
        bool isUpright =
            shape
            is VehicleShape.Van
                or VehicleShape.Suv
                or VehicleShape.Pickup
                or VehicleShape.Minivan
                or VehicleShape.Estate
                or VehicleShape.Hatchback;
        double high = profile.Nose - 0.066;
        double low = high - (isUpright ? 0.09 : 0.07);
        AddPair(lamps, frame, LampKind.Head, LampKind.Head, outer + 0.045, outer + 0.2, 0.955, 0.9925, low, high);
        AddPair(lamps, frame, LampKind.Left, LampKind.Right, outer, outer + 0.045, 0.955, 0.9925, low, high);
        double top = profile.Tail - 0.035;
        if (isUpright)
        {
            AddPair(lamps, frame, LampKind.Tail, LampKind.Tail, outer, outer + 0.08, 0.007, 0.04, top - 0.12, top);
            AddPair(lamps, frame, LampKind.Left, LampKind.Right, outer, outer + 0.08, 0.007, 0.04, top - 0.18, top - 0.12);
        }
        else
        {
            AddPair(lamps, frame, LampKind.Tail, LampKind.Tail, outer, outer + 0.15, 0.007, 0.04, top - 0.1, top);
            AddPair(lamps, frame, LampKind.Left, LampKind.Right, outer + 0.15, outer + 0.22, 0.007, 0.04, top - 0.1, top);
        }

        lamps.Add(
            new VehicleLamp(
                LampKind.HighBrake,
                frame.At(0.42, profile.RoofRear - 0.004, 0.95),
                frame.At(0.58, profile.RoofRear + 0.02, 0.972)
            )
        );
    }

    private static void AddMotorcycle(List<VehicleLamp> lamps, ModelFrame frame, bool isChopper)
    {
        double head = isChopper ? 0.68 : 0.62;
        lamps.Add(Middle(LampKind.Head, frame, 0.4, 0.6, frame.Y(isChopper ? 0.84 : 0.955) - Depth, head, head + 0.15));
        lamps.Add(Middle(LampKind.Tail, frame, 0.4, 0.6, frame.Y(0.03), 0.56, 0.66));
        AddPair(lamps, frame, LampKind.Left, LampKind.Right, 0.22, 0.3, 0.03, 0.05, 0.56, 0.62);
        AddPair(lamps, frame, LampKind.Left, LampKind.Right, 0.14, 0.22, 0.8, 0.83, 0.66, 0.73);
    }

    private static void AddFront(
        List<VehicleLamp> lamps,
        ModelFrame frame,
        double from,
        double to,
        double low,
        double high,
        double indicator
    )
    {
        double near = (frame.Length - FromEnd - Depth) / frame.Length;
        double far = (frame.Length - FromEnd) / frame.Length;
        AddPair(lamps, frame, LampKind.Head, LampKind.Head, from + indicator, to, near, far, low, high);
        AddPair(lamps, frame, LampKind.Left, LampKind.Right, from, from + indicator, near, far, low, high);
    }

    private static void AddRear(
        List<VehicleLamp> lamps,
        ModelFrame frame,
        double from,
        double to,
        double low,
        double high,
        double indicator,
        bool above
    )
    {
        double near = FromEnd / frame.Length;
        double far = (FromEnd + Depth) / frame.Length;
        AddPair(lamps, frame, LampKind.Tail, LampKind.Tail, from, to, near, far, low, high);
        (double indicatorFrom, double indicatorTo) = above ? (from, to) : (to, to + indicator);
        (double indicatorLow, double indicatorHigh) = above ? (high, high + indicator) : (low, high);
        AddPair(lamps, frame, LampKind.Left, LampKind.Right, indicatorFrom, indicatorTo, near, far, indicatorLow, indicatorHigh);
    }

    /// <summary>Adds a lamp on the left and its mirror image on the right; positions are fractions of the box.</summary>
    private static void AddPair(
        List<VehicleLamp> lamps,
        ModelFrame frame,
        LampKind left,
        LampKind right,
        double from,
        double to,
        double rear,
        double front,
        double low,
        double high
    )
    {
        lamps.Add(new VehicleLamp(left, frame.At(from, rear, low), frame.At(to, front, high)));
        lamps.Add(new VehicleLamp(right, frame.At(1 - to, rear, low), frame.At(1 - from, front, high)));
    }

    private static VehicleLamp Middle(LampKind kind, ModelFrame frame, double from, double to, double rear, double low, double high)
    {
        var min = new Vector3D(frame.X(from), rear, frame.Z(low));
        return new VehicleLamp(kind, min, new Vector3D(frame.X(to), rear + Depth, frame.Z(high)));
    }
}
