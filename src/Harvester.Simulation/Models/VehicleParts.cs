using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Parts common to all four-wheeled vehicles.</summary>
internal static class VehicleParts
{
    private const int WheelSides = 16;

    /// <summary>Adds two wheels that stand on the box's floor, each with tyre, rim and the dark of its arch.</summary>
    public static void AddAxle(MeshBuilder builder, ModelFrame frame, double forward, double radius, double breadth, double insetFraction)
    {
        double y = frame.Y(forward);
        AddWheel(builder, new(frame.X(insetFraction), y, frame.Min.Z), 1, radius, breadth);
        AddWheel(builder, new(frame.X(1 - insetFraction), y, frame.Min.Z), -1, radius, breadth);
    }

    /// <summary>Adds lamps at the corners of both ends, number plates and a grille.</summary>
    public static void AddLamps(MeshBuilder builder, ModelFrame frame, double frontHeight, double rearHeight, double height)
    {
        const double stickOut = 0.0005;
        double front = 1 - stickOut;
        foreach (double left in new[] { 0.05, 0.73 })
        {
            Vector3D frontLow = frame.At(left, 0.97, frontHeight);
            builder.AddBox(frontLow, frame.At(left + 0.22, front, frontHeight + height), VehiclePaint.HeadLamp, Surface.NightLamp);
            builder.AddBox(frame.At(left, stickOut, rearHeight), frame.At(left + 0.22, 0.03, rearHeight + height), VehiclePaint.TailLamp,
                Surface.NightLamp);
        }

        builder.AddBox(frame.At(0.3, 0.97, frontHeight), frame.At(0.7, front, frontHeight + height), VehiclePaint.DarkPlastic);
        builder.AddBox(frame.At(0.4, stickOut, rearHeight), frame.At(0.6, 0.03, rearHeight + (height * 0.8)), VehiclePaint.Plate);
    }

    private static void AddWheel(MeshBuilder builder, Vector3D outerFoot, int inward, double radius, double breadth)
    {
        // The lowest corner of the polygonal tyre lies straight below its axle, on the floor; the cylinder's first corner is straight up.
        Vector3D hub = outerFoot + new Vector3D(0, 0, radius);
        Vector3D Inside(double depth) => hub + new Vector3D(inward * depth, 0, 0);
        builder.AddCylinder(Inside(0.004), Inside(breadth), radius, radius, WheelSides, VehiclePaint.Rubber);
        builder.AddCylinder(Inside(0), Inside(0.01), radius * 0.62, radius * 0.62, 10, VehiclePaint.Rim);
        Vector3D lifted = new(0, 0, radius * 0.2);
        builder.AddCylinder(
            Inside(0.009) + lifted, Inside(breadth * 1.1) + lifted, radius * 1.12, radius * 1.12, WheelSides, VehiclePaint.DarkPlastic);
    }
}
