using System;
using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>
/// Cars, off-roaders and vans: a body with bonnet and boot, a cabin of glass under a roof, wheels, bumpers, mirrors and lamps.
/// </summary>
internal static class CarModels
{
    /// <summary>Distance of the body from the box's sides, as a fraction of the width; the mirrors reach the sides.</summary>
    private const double SideInset = 0.012;
    private const double Sill = 0.11;

    public static Mesh Build(VehicleRow row, Rgb colour)
    {
        var frame = new ModelFrame(row.Min, row.Max);
        CarProfile profile = CarProfile.Of(row.Shape);
        var builder = new MeshBuilder();
        AddBody(builder, frame, profile, colour);
        AddCabin(builder, frame, profile, colour, row.Shape);
        double radius = Math.Min(0.36, frame.Height * 0.26);
        VehicleParts.AddAxle(builder, frame, profile.RearAxle, radius, 0.22, SideInset / 2);
        VehicleParts.AddAxle(builder, frame, profile.FrontAxle, radius, 0.22, SideInset / 2);
        VehicleParts.AddLamps(builder, frame, profile.Nose - 0.12, profile.Tail - 0.14, 0.11);
        AddMirrors(builder, frame, profile, colour);
        if (row.Model.StartsWith("police", StringComparison.Ordinal))
        {
            AddPoliceTrim(builder, frame, profile);
        }

        return builder.Build();
    }

    private static void AddBody(MeshBuilder builder, ModelFrame frame, CarProfile profile, Rgb colour)
    {
        double left = frame.X(SideInset);
        Vector3D across = new(frame.X(1 - SideInset) - left, 0, 0);
        Vector3D Side(double forward, double up) => new(left, frame.Y(forward), frame.Z(up));
        builder.AddPrism(
            [
                Side(0.015, Sill), Side(0.985, Sill), Side(0.99, profile.Nose), Side(profile.CabinFront, profile.Belt),
                Side(profile.CabinRear, profile.Belt), Side(0.01, profile.Tail),
            ],
            across,
            colour,
            Surface.Paint);

        // Bumpers reach the ends of the box; at the corners they are set back by less than is visible.
        builder.AddBox(frame.At(SideInset, 0, Sill * 0.45), frame.At(1 - SideInset, 0.05, 0.33), colour.Scaled(0.8), Surface.Paint);
        builder.AddBox(frame.At(SideInset, 0.95, Sill * 0.45), frame.At(1 - SideInset, 1, 0.33), colour.Scaled(0.8), Surface.Paint);
        builder.AddBox(frame.At(0.06, 0.03, Sill * 0.7), frame.At(0.94, 0.97, Sill), VehiclePaint.DarkPlastic);
        AddGap(builder, frame, 0.42, profile);
        AddGap(builder, frame, 0.62, profile);
    }

    /// <summary>Adds the gap of a door as a dark line on both sides.</summary>
    private static void AddGap(MeshBuilder builder, ModelFrame frame, double forward, CarProfile profile)
    {
        foreach (double side in new[] { SideInset - 0.001, 1 - SideInset + 0.001 })
        {
            builder.AddQuad(
                frame.At(side, forward, 0.2), frame.At(side, forward + 0.004, 0.2),
                frame.At(side, forward + 0.004, profile.Belt), frame.At(side, forward, profile.Belt), VehiclePaint.DarkPlastic);
        }
    }

    private static void AddCabin(MeshBuilder builder, ModelFrame frame, CarProfile profile, Rgb colour, VehicleShape shape)
    {
        const double roofThickness = 0.045;
        double roofInset = shape is VehicleShape.Van or VehicleShape.Suv or VehicleShape.Minivan ? 0.09 : 0.15;
        double roofLine = 1 - roofThickness;
        Vector3D low = frame.At(0.045, profile.CabinRear, profile.Belt);
        Vector3D high = frame.At(0.955, profile.CabinFront, roofLine);
        Vector3D roofLow = frame.At(roofInset, profile.RoofRear, roofLine);
        Vector3D roofHigh = frame.At(1 - roofInset, profile.RoofFront, roofLine);
        bool isPanelled = shape == VehicleShape.Van;
        builder.AddFrustum(low, high, roofLow, roofHigh, VehiclePaint.Window, Surface.Glass);
        builder.AddFrustum(
            roofLow, roofHigh with { Z = frame.Max.Z }, frame.At(roofInset + 0.03, profile.RoofRear + 0.02, 1),
                frame.At(1 - roofInset - 0.03, profile.RoofFront - 0.02, 1), colour, Surface.Paint);
        foreach (int side in new[] { -1, 1 })
        {
            double bottomX = side < 0 ? low.X : high.X;
            double topX = side < 0 ? roofLow.X : roofHigh.X;
            AddPillar(builder, side, bottomX, topX, low.Y, roofLow.Y, isPanelled ? frame.Length * 0.6 : 0.14, low.Z, roofLow.Z, colour);
            AddPillar(builder, side, bottomX, topX, high.Y, roofHigh.Y, -0.09, low.Z, roofLow.Z, colour);
            double middle = frame.Y(0.42);
            AddPillar(builder, side, bottomX, topX, middle, middle, 0.08, low.Z, roofLow.Z, colour);
        }
    }

    /// <summary>Adds a strip of paint on the cabin's side, slightly outside the glass.</summary>
    private static void AddPillar(
        MeshBuilder builder, int side, double bottomX, double topX, double bottomY, double topY, double breadth, double bottomZ,
            double topZ, Rgb colour)
    {
        double outward = side * 0.008;
        builder.AddQuad(
            new(bottomX + outward, bottomY, bottomZ), new(bottomX + outward, bottomY + breadth, bottomZ),
            new(topX + outward, topY + breadth, topZ), new(topX + outward, topY, topZ), colour, Surface.Paint);
    }

    private static void AddMirrors(MeshBuilder builder, ModelFrame frame, CarProfile profile, Rgb colour)
    {
        double forward = profile.CabinFront - 0.07;
        builder.AddBox(frame.At(0, forward, profile.Belt), frame.At(0.05, forward + 0.03, profile.Belt + 0.09), colour, Surface.Paint);
        builder.AddBox(frame.At(0.95, forward, profile.Belt), frame.At(1, forward + 0.03, profile.Belt + 0.09), colour, Surface.Paint);
    }

    private static void AddPoliceTrim(MeshBuilder builder, ModelFrame frame, CarProfile profile)
    {
        double middle = (profile.RoofRear + profile.RoofFront) / 2;
        builder.AddBox(frame.At(0.26, middle - 0.02, 0.93), frame.At(0.5, middle + 0.02, 1), new(190, 20, 24), Surface.NightLamp);
        builder.AddBox(frame.At(0.5, middle - 0.02, 0.93), frame.At(0.74, middle + 0.02, 1), new(24, 50, 200), Surface.NightLamp);
    }
}
