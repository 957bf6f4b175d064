using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Simulation.Streets;

/// <summary>Where town and country are, judged by the length of the roads around a place.</summary>
internal sealed class Settlement
{
    private const double CellSize = 100;

    /// <summary>Radius of the surroundings that make a town, metres, and of those that make a village.</summary>
    private const double WideRadius = 1200;

    private const double NearRadius = 250;

    /// <summary>
    /// Kilometres of road per square kilometre within the wide radius. In GTA V's network the centre of Los Santos has 39 to 42, its
    /// quarters 20 to 34, its outskirts 14 to 20, and the country less than 11.
    /// </summary>
    private const double CentreDensity = 36;

    private const double TownDensity = 20;
    private const double SuburbDensity = 11.5;

    /// <summary>The same within the near radius for a village; a desert town of GTA V has 28, a road through fields 12.</summary>
    private const double VillageDensity = 17;

    /// <summary>Total length of roads below which a network does not show where its town ends, metres; it is all town.</summary>
    private const double MinNetwork = 50_000;

    /// <summary>Radii of the centre and of the town that is generated, metres from its middle.</summary>
    private const double GeneratedCentre = 200;

    private const double GeneratedTown = 430;

    private readonly Func<Vector3D, Zone> _zone;

    private Settlement(Func<Vector3D, Zone> zone) => _zone = zone;

    /// <summary>Town without end.</summary>
    public static Settlement Everywhere { get; } = new(_ => Zone.Town);

    /// <summary>The town that is generated, with the country around it.</summary>
    public static Settlement Generated { get; } =
        new(place =>
            Horizontal.Distance(place, Vector3D.Zero) is var distance && distance < GeneratedCentre ? Zone.Centre
            : distance < GeneratedTown ? Zone.Town
            : Zone.Country
        );

    /// <summary>Judges a network near a point.</summary>
    public static Settlement Of(RoadNetwork network, Vector3D centre)
    {
        const RoadNodeFlags wild = RoadNodeFlags.Water | RoadNodeFlags.OffRoad;
        double total = 0;
        Dictionary<(int X, int Y), double> metres = [];
        foreach (RoadLink link in network.Links)
        {
            RoadNode from = network.Nodes[link.From];
            RoadNode to = network.Nodes[link.To];
            if (((from.Flags | to.Flags) & wild) != 0 || link.LanesForward + link.LanesBackward == 0)
            {
                continue;
            }

            double length = Horizontal.Distance(from.Position, to.Position);
            total += length;
            (int X, int Y) cell = CellOf((from.Position + to.Position) / 2);
            metres[cell] = metres.GetValueOrDefault(cell) + length;
        }

        return total < MinNetwork ? Everywhere : new Settlement(new Densities(metres, CellOf(centre)).ZoneAt);
    }

    /// <summary>The zone of a place.</summary>
    public Zone At(Vector3D place) => _zone(place);

    private static (int X, int Y) CellOf(Vector3D place) => ((int)Math.Floor(place.X / CellSize), (int)Math.Floor(place.Y / CellSize));

    /// <summary>The zones of cells near a centre; cells farther away have the zone of the nearest of them.</summary>
    private sealed class Densities(Dictionary<(int X, int Y), double> metres, (int X, int Y) centre)
    {
        private const int Cells = 8;

        private readonly Zone[] _zones =
        [
            .. Enumerable
                .Range(0, Squared((2 * Cells) + 1))
                .Select(i => ZoneOf(metres, centre.X - Cells + (i % ((2 * Cells) + 1)), centre.Y - Cells + (i / ((2 * Cells) + 1)))),
        ];

        public Zone ZoneAt(Vector3D place)
        {
            (int x, int y) = CellOf(place);
            int i = Math.Clamp(x - centre.X, -Cells, Cells) + Cells;
            int j = Math.Clamp(y - centre.Y, -Cells, Cells) + Cells;
            return _zones[(j * ((2 * Cells) + 1)) + i];
        }

        private static int Squared(int value) => value * value;

        private static Zone ZoneOf(Dictionary<(int X, int Y), double> metres, int x, int y)
        {
            double wide = DensityAround(metres, x, y, WideRadius);
            return wide >= CentreDensity ? Zone.Centre
                : wide >= TownDensity ? Zone.Town
                : wide >= SuburbDensity || DensityAround(metres, x, y, NearRadius) >= VillageDensity ? Zone.Suburb
                : Zone.Country;
        }

        /// <summary>Kilometres of road per square kilometre.</summary>
        private static double DensityAround(Dictionary<(int X, int Y), double> metres, int x, int y, double radius)
        {
            int reach = (int)(radius / CellSize);
            double sum = 0;
            int cells = 0;
            for (int i = -reach; i <= reach; i++)
            {
                for (int j = -reach; j <= reach; j++)
                {
                    if ((i * i) + (j * j) <= reach * reach)
                    {
                        sum += metres.GetValueOrDefault((x + i, y + j));
                        cells++;
                    }
                }
            }

            const double metresPerKilometre = 1000;
            return sum / metresPerKilometre / (cells * CellSize * CellSize / (metresPerKilometre * metresPerKilometre));
        }
    }
}
