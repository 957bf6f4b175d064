using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// Plans where pictures are taken from above so that they show the carriageways of roads: along the roads, each picture is placed so that
/// the first row that is not shown yet lies at its rear border.
/// </summary>
public sealed class StationPlan
{
    /// <summary>Distance ahead below which a picture is placed above the row itself, metres.</summary>
    private const double MinAhead = 1;

    /// <summary>Links that are followed ahead: more than lie in half of a picture.</summary>
    private const int MaxLinks = 100;

    private readonly PaintRoads _roads;
    private readonly SurveyFootprint _footprint;
    private readonly SurveyStrips _strips;
    private readonly List<SurveyStation> _stations = [];
    private int _rows;

    private StationPlan(PaintRoads roads, SurveyFootprint footprint, SurveyArea? area, IReadOnlyCollection<SurveyStation> photographed)
    {
        _roads = roads;
        _footprint = footprint;
        _strips = new SurveyStrips(roads, footprint, area);
        RoadNetwork network = roads.Curves.Network;
        if (network.Nodes.Count == 0)
        {
            return;
        }

        foreach (SurveyStation station in photographed)
        {
            _strips.Mark(station);
        }

        bool IsInArea(int link) => area?.MayHave(roads.Curves.Of(link)) != false;
        foreach ((int link, bool isForward) in TravelOrder.Of(network, IsInArea, area is null ? 0 : NearestNode(network, area.Places[0])))
        {
            Cover(link, isForward);
        }
    }

    /// <summary>The stations, in the order in which they are visited.</summary>
    public IReadOnlyList<SurveyStation> Stations => _stations;

    /// <summary>Length of the roads that the pictures show, metres.</summary>
    public double RoadMetres => _rows * PaintRow.Length;

    /// <summary>Plans the pictures of the drivable roads, without junctions.</summary>
    /// <param name="roads">The roads.</param>
    /// <param name="footprint">The ground that a picture shows.</param>
    /// <param name="area">Where the roads lie; null for all roads.</param>
    /// <param name="photographed">Stations of an earlier survey; what their pictures show is left out. Null for none.</param>
    public static StationPlan Of(
        PaintRoads roads,
        SurveyFootprint footprint,
        SurveyArea? area,
        IReadOnlyCollection<SurveyStation>? photographed = null
    ) => new(Guard.NotNull(roads, nameof(roads)), footprint, area, photographed ?? []);

    private static int NearestNode(RoadNetwork network, Vector2D place)
    {
        int nearest = 0;
        double least = double.PositiveInfinity;
        for (int node = 0; node < network.Nodes.Count; node++)
        {
            Vector3D position = network.Nodes[node].Position;
            double distance = (new Vector2D(position.X, position.Y) - place).Length;
            if (distance < least)
            {
                (nearest, least) = (node, distance);
            }
        }

        return nearest;
    }

    private void Cover(int link, bool isForward)
    {
        int rows = _roads.RowsOf(link);
        for (int strip = 0; strip < _strips.CountOn(link); strip++)
        {
            for (int i = 0; i < rows; i++)
            {
                int row = isForward ? i : rows - 1 - i;
                if (!_strips.IsShown(link, row, strip))
                {
                    SurveyStation station = StationFor(link, row, strip, isForward);
                    _strips.Mark(link, row, strip);
                    _strips.Mark(station);
                    _stations.Add(station);
                }
            }
        }

        for (int row = 0; row < rows; row++)
        {
            _rows += _strips.IsWanted(link, row) ? 1 : 0;
        }
    }

    /// <summary>The station farthest ahead from which a strip at a row is shown; in a bend that is not half of the footprint.</summary>
    private SurveyStation StationFor(int link, int row, int strip, bool isForward)
    {
        for (double ahead = _footprint.HalfAlong - PaintRow.Length; ahead > MinAhead; ahead /= 2)
        {
            SurveyStation station = Ahead(link, row, strip, isForward, ahead);
            if (_strips.IsShownFrom(station, link, row, strip))
            {
                return station;
            }
        }

        return Ahead(link, row, strip, isForward, 0);
    }

    /// <summary>The station so far ahead of a row, along the links that continue the road.</summary>
    private SurveyStation Ahead(int link, int row, int strip, bool isForward, double metres)
    {
        RoadCurves curves = _roads.Curves;
        double offset = _strips.MiddleOf(link, strip) * (isForward ? 1 : -1);
        double station = _roads.StationOf(link, row);
        for (int links = 1; ; links++)
        {
            RoadCurve curve = curves.Of(link);
            double left = isForward ? curve.Length - station : station;
            int next = curves.Continuations.Of(link, isForward);

            // Links without a length can be a ring.
            if (metres <= left || next == RoadContinuations.None || links == MaxLinks)
            {
                double parameter = curve.ParameterAt(station + (Math.Min(metres, left) * (isForward ? 1 : -1)));
                return new SurveyStation(
                    curve.PointBeside(parameter, isForward ? offset : -offset),
                    curve.DirectionAt(parameter) * (isForward ? 1 : -1)
                );
            }

            metres -= left;
            RoadLink road = curves.Network.Links[link];
            int node = isForward ? road.To : road.From;
            link = next;
            isForward = curves.Network.Links[next].From == node;
            station = isForward ? 0 : curves.Of(next).Length;
        }
    }
}
