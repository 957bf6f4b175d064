using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>
/// Covers the roads whose nodes are in a tunnel: lined walls, a ceiling with rows of lamps, ground on top, and portals at the ends.
/// </summary>
internal sealed class TunnelBuilder(StreetIndex index, Asphalt asphalt, GroundMesh mesh)
{
    /// <summary>Height of the ceiling above the road, metres; lorries are up to 4.3 m high.</summary>
    private const double CeilingHeight = 5.4;

    private const double RoofHeight = 6.4;
    private const double TilesFrom = 0.9;
    private const double TilesTo = 3.4;

    /// <summary>Distance of the walls from the border of the asphalt, and their thickness, metres.</summary>
    private const double BesideAsphalt = 0.6;
    private const double WallThickness = 1;

    /// <summary>Width of the slope beside a tunnel, and how deep it reaches below the road, metres.</summary>
    private const double SlopeWidth = 11;
    private const double Buried = 1;

    /// <summary>Pieces of the road between two pairs of lamps.</summary>
    private const int LampEvery = 2;

    private static readonly Rgb Tiles = new(188, 186, 176);
    private static readonly Rgb Dark = new(96, 96, 94);
    private static readonly Rgb LampColour = new(255, 232, 190);

    /// <summary>Covers a road, if it is in a tunnel.</summary>
    public void Build(Road road)
    {
        if (!road.IsInTunnel)
        {
            return;
        }

        IReadOnlyList<double> stations = asphalt.Of(road).Stations;
        for (int i = 1; i < stations.Count; i++)
        {
            RoadRibbon piece = new(road, [stations[i - 1], stations[i]], mesh);
            Cover(road, piece, (stations[i - 1] + stations[i]) / 2);
            if (i % LampEvery == 0)
            {
                AddLamps(road, piece);
            }
        }

        AddPortal(road, 0);
        AddPortal(road, road.Length);
    }

    private void Cover(Road road, RoadRibbon piece, double middle)
    {
        double left = road.LeftKerb - BesideAsphalt;
        double right = road.RightKerb + BesideAsphalt;
        piece.Lay(new Rail(left, CeilingHeight), new Rail(right, CeilingHeight), Dark, Surface.Matte, SurfaceKind.Building);
        piece.Lay(
            new Rail(left - WallThickness, RoofHeight),
            new Rail(right + WallThickness, RoofHeight),
            Palette.DryGrass,
            Surface.Ground,
            SurfaceKind.Terrain
        );
        foreach (int side in new[] { -1, 1 })
        {
            double wall = side < 0 ? left : right;
            double outer = wall + (side * WallThickness);
            if (!IsFree(road, middle, wall, 0))
            {
                continue;
            }

            piece.Lay(new Rail(wall, -Buried), new Rail(wall, TilesFrom), Dark, Surface.Matte, SurfaceKind.Building);
            piece.Lay(new Rail(wall, TilesFrom), new Rail(wall, TilesTo), Tiles, Surface.Matte, SurfaceKind.Building);
            piece.Lay(new Rail(wall, TilesTo), new Rail(wall, CeilingHeight), Palette.Concrete, Surface.Matte, SurfaceKind.Building);
            bool hasSlope = IsFree(road, middle, outer + (side * SlopeWidth), SlopeWidth);
            piece.Lay(
                new Rail(outer, RoofHeight),
                new Rail(hasSlope ? outer + (side * SlopeWidth) : outer, -Buried),
                hasSlope ? Palette.DryGrass : Palette.Concrete,
                hasSlope ? Surface.Ground : Surface.Matte,
                hasSlope ? SurfaceKind.Terrain : SurfaceKind.Building
            );
        }
    }

    private static void AddLamps(Road road, RoadRibbon piece)
    {
        const double fromWall = 2;
        const double halfWidth = 0.2;
        const double belowCeiling = 0.03;
        foreach (double middle in new[] { road.LeftKerb + fromWall, road.RightKerb - fromWall })
        {
            piece.Lay(
                new Rail(middle - halfWidth, CeilingHeight - belowCeiling),
                new Rail(middle + halfWidth, CeilingHeight - belowCeiling),
                LampColour,
                Surface.Lamp,
                SurfaceKind.Building
            );
        }
    }

    /// <summary>Adds the face of the walls, the roof and the slopes at an end.</summary>
    private void AddPortal(Road road, double distance)
    {
        double left = road.LeftKerb - BesideAsphalt;
        double right = road.RightKerb + BesideAsphalt;
        Face((left, CeilingHeight), (right, CeilingHeight), (right, RoofHeight), (left, RoofHeight));
        foreach (int side in new[] { -1, 1 })
        {
            double wall = side < 0 ? left : right;
            double outer = wall + (side * WallThickness);
            if (!IsFree(road, distance, wall, 0))
            {
                continue;
            }

            Face((wall, -Buried), (outer, -Buried), (outer, RoofHeight), (wall, RoofHeight));
            if (IsFree(road, distance, outer + (side * SlopeWidth), SlopeWidth))
            {
                Face((outer, -Buried), (outer + (side * SlopeWidth), -Buried), (outer, RoofHeight), (outer, RoofHeight));
            }
        }

        void Face(params (double Right, double Up)[] corners)
        {
            Vector3D[] places = [.. corners.Select(corner => road.Curve.OffsetAt(distance, corner.Right) + (Horizontal.Up * corner.Up))];
            mesh.AddQuad(places[0], places[1], places[2], places[3], Palette.Concrete, Surface.Matte, SurfaceKind.Building);
        }
    }

    /// <summary>Whether no other road is within a margin of a place beside a road.</summary>
    private bool IsFree(Road road, double distance, double rightOffset, double margin) =>
        !index.IsOnAnother(road, road.Curve.OffsetAt(distance, rightOffset), margin + Road.WidestShoulder);
}
