using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>
/// Builds what joins a road's edges to the ground: pavements, banks where the ground is near, retaining walls where it is lower, and the
/// decks of bridges with their parapets, abutments and piers.
/// </summary>
internal sealed class RoadSides(StreetIndex index, Terrain terrain, RoadLevels levels, Asphalt asphalt, GroundMesh mesh)
{
    /// <summary>Depth of the ground below an edge up to which grass slopes down to it, metres; deeper ground has a wall.</summary>
    private const double MaxBank = 1.4;

    /// <summary>Depth of the ground below both edges from which a road stands on piers without crossing anything, metres.</summary>
    private const double MaxWall = 8;

    private const double BankWidth = 1.6;
    private const double Buried = 0.4;
    private const double ParapetHeight = 0.9;
    private const double ParapetThickness = 0.3;

    /// <summary>Depth of ground from which a wall has a parapet, metres.</summary>
    private const double ParapetAbove = 1.2;

    private const double DeckThickness = 1.2;
    private const double ThinnestDeck = 0.35;

    /// <summary>Height that a deck leaves free above a lower road, metres; lorries are up to 4.3 m high.</summary>
    private const double ClearHeight = 4.7;

    private const double OnLevel = 2.5;
    private const double PierSpacing = 24;
    private const double PierThickness = 1.2;

    /// <summary>Distance of a pier from the asphalt of other roads, metres.</summary>
    private const double PierRoom = 0.5;

    /// <summary>Builds the sides of a road.</summary>
    public void Build(Road road)
    {
        IReadOnlyList<double> stations = asphalt.Of(road).Stations;
        bool wasOpen = false;
        double run = PierSpacing / 2;
        RoadSection near = SectionAt(road, stations[0]);
        for (int i = 1; i < stations.Count; i++)
        {
            RoadSection far = SectionAt(road, stations[i]);
            double middle = (near.Distance + far.Distance) / 2;
            bool isOpen = IsOpen(road, middle, Math.Min(near.MinGap, far.MinGap));
            double thickness = isOpen ? ThicknessAt(road, middle) : 0;
            bool isShared = levels.IsShared(road, near.Distance, far.Distance);
            AddSide(road, near, far, 1, isOpen ? thickness : null, isShared);
            AddSide(road, near, far, -1, isOpen ? thickness : null, isShared);
            if (isOpen)
            {
                Vector3D down = Horizontal.Up * -thickness;
                mesh.AddQuad(
                    near.Left.Edge + down,
                    near.Right.Edge + down,
                    far.Right.Edge + down,
                    far.Left.Edge + down,
                    Palette.Concrete,
                    Surface.Matte,
                    SurfaceKind.Building
                );
                run += far.Distance - near.Distance;
                if (run >= PierSpacing && TryAddPier(road, middle, thickness))
                {
                    run = 0;
                }
            }
            else
            {
                run = PierSpacing / 2;
            }

            if (isOpen != wasOpen && i > 1)
            {
                AddAcross(near);
            }

            wasOpen = isOpen;
            near = far;
        }
    }

    /// <summary>Adds the wall below an end of a road that leads nowhere.</summary>
    public void AddEnd(RoadArm arm) => AddAcross(SectionAt(arm.Road, arm.DistanceAt(0)));

    /// <summary>Whether the road is on a bridge: there is nothing between its deck and the ground but piers.</summary>
    private bool IsOpen(Road road, double distance, double minGap) =>
        minGap > MaxWall || (minGap > OnLevel && levels.IsSuspended(road, distance));

    private double ThicknessAt(Road road, double distance) =>
        Math.Clamp(levels.RoomBelow(road, distance) - ClearHeight, ThinnestDeck, DeckThickness);

    /// <param name="road">The road.</param>
    /// <param name="near">Where the piece begins.</param>
    /// <param name="far">Where it ends.</param>
    /// <param name="side">+1 on the right, -1 on the left.</param>
    /// <param name="deck">Thickness of the deck of a bridge, metres; null on the ground.</param>
    /// <param name="isShared">Whether another road may be on or beside the road.</param>
    private void AddSide(Road road, in RoadSection near, in RoadSection far, int side, double? deck, bool isShared)
    {
        StreetEdge from = side > 0 ? near.Right : near.Left;
        StreetEdge to = side > 0 ? far.Right : far.Left;
        Vector3D up = Horizontal.Up;
        double height = road.IsStreet ? Walkway.KerbHeight : 0;
        bool isFolded = (to.Edge - from.Edge).Dot(to.Kerb - from.Kerb) <= 0;
        bool isFree = !isShared || IsClear(road, (from.Kerb + from.Edge + to.Kerb + to.Edge) / 4);
        if (isFolded || !isFree)
        {
            return;
        }

        if (road.IsStreet)
        {
            Lay(from.Kerb, to.Kerb, 0, from.Kerb, to.Kerb, height, Palette.Kerb, Surface.Matte, SurfaceKind.Pavement);
            Lay(from.Kerb, to.Kerb, height, from.Edge, to.Edge, height, Palette.Pavement, Surface.Ground, SurfaceKind.Pavement);
        }

        if (isShared && !(IsClear(road, from.Edge) && IsClear(road, (from.Edge + to.Edge) / 2) && IsClear(road, to.Edge)))
        {
            return;
        }

        double gap = Math.Max(from.Gap, to.Gap);
        if (deck is not null || gap > MaxBank)
        {
            Vector3D outerFrom = from.Edge + (from.Outward * ParapetThickness);
            Vector3D outerTo = to.Edge + (to.Outward * ParapetThickness);
            bool hasParapet = deck is not null || gap > ParapetAbove;
            SurfaceKind inner = hasParapet ? SurfaceKind.Fence : SurfaceKind.Building;
            double top = hasParapet ? ParapetHeight : height;
            Lay(from.Edge, to.Edge, 0, from.Edge, to.Edge, top, Palette.Concrete, Surface.Matte, inner);
            Lay(from.Edge, to.Edge, top, outerFrom, outerTo, top, Palette.Concrete, Surface.Matte, inner);
            mesh.AddQuad(
                outerFrom + (up * top),
                outerFrom - (up * (deck ?? (from.Gap + Buried))),
                outerTo - (up * (deck ?? (to.Gap + Buried))),
                outerTo + (up * top),
                Palette.Concrete,
                Surface.Matte,
                SurfaceKind.Building
            );
            if (deck is { } thickness)
            {
                Lay(from.Edge, to.Edge, -thickness, outerFrom, outerTo, -thickness, Palette.Concrete, Surface.Matte, SurfaceKind.Building);
            }

            return;
        }

        mesh.AddQuad(
            from.Edge + (up * height),
            FootOf(from),
            FootOf(to),
            to.Edge + (up * height),
            Palette.Grass,
            Surface.Ground,
            SurfaceKind.Terrain
        );

        void Lay(
            Vector3D fromA,
            Vector3D toA,
            double heightA,
            Vector3D fromB,
            Vector3D toB,
            double heightB,
            Rgb colour,
            Surface surface,
            SurfaceKind kind
        ) =>
            mesh.AddQuad(fromA + (up * heightA), fromB + (up * heightB), toB + (up * heightB), toA + (up * heightA), colour, surface, kind);
    }

    /// <summary>Where the bank beside an edge enters the ground.</summary>
    private Vector3D FootOf(StreetEdge edge)
    {
        Vector3D foot = edge.Edge + (edge.Outward * BankWidth);
        return foot with { Z = Math.Min(terrain.HeightAt(foot), edge.Edge.Z) - Buried };
    }

    /// <summary>Adds a wall across the road from the asphalt down into the ground.</summary>
    private void AddAcross(in RoadSection section)
    {
        const double belowAsphalt = 0.05;
        Vector3D high = Horizontal.Up * -belowAsphalt;
        Vector3D low = Horizontal.Up * -(section.MaxGap + Buried);
        mesh.AddQuad(
            section.Left.Edge + high,
            section.Right.Edge + high,
            section.Right.Edge + low,
            section.Left.Edge + low,
            Palette.Concrete,
            Surface.Matte,
            SurfaceKind.Building
        );
    }

    private bool TryAddPier(Road road, double distance, double thickness)
    {
        double half = Math.Min(-road.LeftKerb, road.RightKerb) * 0.6;
        CrossSection section = road.Curve.SectionAt(distance);
        const int points = 4;
        for (int i = 0; i <= points; i++)
        {
            Vector3D place = section.At(half * ((2.0 * i / points) - 1));
            if (
                index
                    .PlacesAt(place, PierThickness, except: road)
                    .Any(other => other.Height > OnLevel && other.IsOnCarriageway(other.Road.Shoulder + PierRoom + PierThickness))
            )
            {
                return false;
            }
        }

        Vector3D along = new Vector3D(section.Right.Y, -section.Right.X, 0) * (PierThickness / 2);
        Vector3D low = section.Centre with { Z = terrain.HeightAt(section.Centre) - 1 };
        Vector3D high = section.Centre - (Horizontal.Up * thickness);
        Vector3D[] around =
        [
            (section.Right * half) + along,
            (section.Right * half) - along,
            (section.Right * -half) - along,
            (section.Right * -half) + along,
        ];
        for (int i = 0; i < around.Length; i++)
        {
            Vector3D next = around[(i + 1) % around.Length];
            mesh.AddQuad(low + around[i], low + next, high + next, high + around[i], Palette.Concrete, Surface.Matte, SurfaceKind.Building);
        }

        return true;
    }

    private RoadSection SectionAt(Road road, double distance)
    {
        RoadFacets facets = asphalt.Of(road);
        CrossSection section = road.Curve.SectionAt(distance);
        double middle = facets.At(distance, 0).Z;
        double gap = middle - terrain.HeightAt(section.Centre);
        return new RoadSection(distance, EdgeAt(-1), EdgeAt(1), gap);

        StreetEdge EdgeAt(int side)
        {
            double kerb = side > 0 ? road.RightKerb : road.LeftKerb;
            double beyond = road.IsStreet ? Walkway.Width : 0;
            double height = facets.At(distance, kerb).Z;
            Vector3D edge = section.At(kerb + (side * beyond)) with { Z = height };
            Vector3D outward = section.Right * side;
            return new StreetEdge(
                section.At(kerb) with
                {
                    Z = height,
                },
                edge,
                outward,
                height - terrain.HeightAt(edge + (outward * ParapetThickness))
            );
        }
    }

    /// <summary>Whether no other road's asphalt is at a point beside a road, on its level.</summary>
    private bool IsClear(Road road, Vector3D place) =>
        !index
            .PlacesAt(place, except: road, beside: Road.WidestShoulder)
            .Any(other => Math.Abs(other.Height) < OnLevel && other.IsOnCarriageway(other.Road.Shoulder));
}
