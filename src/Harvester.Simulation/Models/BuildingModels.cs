using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Makes buildings of any size. The origin is the middle of the footprint on the ground.</summary>
public static class BuildingModels
{
    private const double FloorHeight = 3.3;
    private const double LitShare = 0.4;
    private static readonly Rgb[] Plaster =
    [
        new(206, 192, 166),
        new(186, 170, 148),
        new(160, 96, 76),
        new(196, 190, 182),
        new(172, 178, 184),
        new(214, 178, 140),
        new(146, 136, 124),
    ];

    private static readonly Rgb[] Roofs = [new(142, 74, 54), new(96, 90, 88), new(118, 84, 62)];
    private static readonly Rgb[] LampLight = [new(255, 214, 140), new(255, 232, 186), new(214, 226, 255)];
    private static readonly Rgb DarkGlass = new(44, 58, 70);
    private static readonly Rgb Tar = new(70, 70, 72);

    /// <summary>Makes a building.</summary>
    /// <param name="style">How it looks.</param>
    /// <param name="width">Metres along x.</param>
    /// <param name="depth">Metres along y.</param>
    /// <param name="height">Metres, without the roof of a house.</param>
    /// <param name="seed">Chooses colours and which windows are lit at night.</param>
    public static Mesh Create(BuildingStyle style, double width, double depth, double height, int seed)
    {
        var random = new Random(seed);
        var builder = new MeshBuilder { Kind = SurfaceKind.Building };
        Rgb wall = Plaster[random.Next(Plaster.Length)].Scaled(0.85 + (random.NextDouble() * 0.3));
        var min = new Vector3D(-width / 2, -depth / 2, 0);
        var max = new Vector3D(width / 2, depth / 2, height);
        builder.AddBox(min, max, wall);
        (double windowWidth, double gap, double windowHeight) = style switch
        {
            BuildingStyle.Tower => (2.6, 0.25, 2.3),
            BuildingStyle.Warehouse => (2.2, 3.4, 0.8),
            BuildingStyle.House => (1.3, 1.7, 1.3),
            _ => (1.5, 1.3, 1.7),
        };
        var facade = new Facade(builder, random, windowWidth, gap, windowHeight, style == BuildingStyle.Warehouse);
        facade.Add(new(min.X, min.Y, 0), new(1, 0, 0), width, height);
        facade.Add(new(max.X, min.Y, 0), new(0, 1, 0), depth, height);
        facade.Add(new(max.X, max.Y, 0), new(-1, 0, 0), width, height);
        facade.Add(new(min.X, max.Y, 0), new(0, -1, 0), depth, height);
        AddRoof(builder, style, min, max, wall, random);
        return builder.Build();
    }

    private static void AddRoof(MeshBuilder builder, BuildingStyle style, Vector3D min, Vector3D max, Rgb wall, Random random)
    {
        if (style == BuildingStyle.House)
        {
            double inset = Math.Min(max.X - min.X, max.Y - min.Y) * 0.42;
            var over = new Vector3D(0.5, 0.5, 0);
            Vector3D low = (min - over) with { Z = max.Z };
            Vector3D high = (max + over) with { Z = max.Z + (inset * 0.6) };
            var topInset = new Vector3D(inset, inset, 0);
            builder.AddFrustum(low, high, min + topInset, max - topInset, Roofs[random.Next(Roofs.Length)]);
            return;
        }

        // A tarred roof behind a parapet, with the box of an elevator or a cooler on it.
        var parapet = new Vector3D(0.15, 0.15, 0);
        builder.AddBox((min - parapet) with { Z = max.Z - 0.3 }, max + parapet + new Vector3D(0, 0, 0.5), wall.Scaled(0.86));
        builder.AddQuad(
            new(min.X + 0.2, min.Y + 0.2, max.Z + 0.51),
            new(max.X - 0.2, min.Y + 0.2, max.Z + 0.51),
            new(max.X - 0.2, max.Y - 0.2, max.Z + 0.51),
            new(min.X + 0.2, max.Y - 0.2, max.Z + 0.51),
            Tar
        );
        double x = min.X + ((max.X - min.X) * (0.25 + (random.NextDouble() * 0.3)));
        double y = min.Y + ((max.Y - min.Y) * (0.25 + (random.NextDouble() * 0.3)));
        builder.AddBox(
            new(x, y, max.Z + 0.5),
            new(x + ((max.X - min.X) * 0.2), y + ((max.Y - min.Y) * 0.2), max.Z + 2.6),
            wall.Scaled(0.75)
        );
    }

    /// <summary>Puts windows on walls.</summary>
    private sealed class Facade(MeshBuilder builder, Random random, double windowWidth, double gap, double windowHeight, bool isHigh)
    {
        private const double StickOut = 0.03;

        /// <summary>Adds a wall from a lower corner along a horizontal direction; its outer side is on the right.</summary>
        public void Add(Vector3D corner, Vector3D along, double length, double height)
        {
            Vector3D outward = new Vector3D(along.Y, -along.X, 0) * StickOut;
            int floors = Math.Max(1, (int)(height / FloorHeight));
            int columns = (int)((length - gap) / (windowWidth + gap));
            double margin = (length - (columns * (windowWidth + gap)) + gap) / 2;
            for (int floor = isHigh ? floors - 1 : 0; floor < floors; floor++)
            {
                double sill = (floor * FloorHeight) + (floor == 0 && !isHigh ? 0.5 : (FloorHeight - windowHeight) * 0.55);
                double top = floor == 0 && !isHigh ? 2.7 : sill + windowHeight;
                for (int column = 0; column < columns; column++)
                {
                    AddWindow(corner + outward + (along * (margin + (column * (windowWidth + gap)))), along, sill, top);
                }
            }
        }

        private void AddWindow(Vector3D foot, Vector3D along, double sill, double top)
        {
            bool isLit = random.NextDouble() < LitShare;
            Rgb lamp = LampLight[random.Next(LampLight.Length)].Scaled(0.6 + (random.NextDouble() * 0.4));
            Vector3D across = along * windowWidth;
            Vector3D low = foot + new Vector3D(0, 0, sill);
            Vector3D high = foot + new Vector3D(0, 0, top);
            builder.AddQuad(low, low + across, high + across, high, isLit ? lamp : DarkGlass, isLit ? Surface.LitWindow : Surface.Glass);
        }
    }
}
