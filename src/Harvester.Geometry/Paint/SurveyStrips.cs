using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// What a survey of paint has to show: the rows of the carriageways, divided across into strips that fit into a footprint, and which of
/// them are shown already.
/// </summary>
/// <param name="roads">The roads.</param>
/// <param name="footprint">The footprint of a picture.</param>
/// <param name="area">Rows outside it are left out; null for none.</param>
internal sealed class SurveyStrips(PaintRoads roads, SurveyFootprint footprint, SurveyArea? area)
{
    /// <summary>Widest lane, metres; wider ones are not known in the game.</summary>
    private const double MaxLaneWidth = 6.5;

    /// <summary>Shoulder beyond the lanes that is shown too, metres: edge lines lie on it.</summary>
    private const double Shoulder = 1;

    private readonly Dictionary<int, bool[]> _isShown = [];

    /// <summary>Number of strips side by side on a link.</summary>
    public int CountOn(int link) => Math.Max(1, (int)Math.Ceiling(HalfWidth(link) / footprint.HalfAcross));

    /// <summary>The middle of a strip: offset to the right of the link's curve, metres.</summary>
    public double MiddleOf(int link, int strip) => (((2 * strip) + 1.0) / CountOn(link) * HalfWidth(link)) - HalfWidth(link);

    /// <summary>Whether a row belongs to the survey: it is in range and in no junction.</summary>
    public bool IsWanted(int link, int row)
    {
        double station = roads.StationOf(link, row);
        Vector3D place = roads.Curves.Of(link).PointAt(roads.Curves.Of(link).ParameterAt(station));
        return !roads.Junctions.Contains(link, station) && area?.Contains(place) != false;
    }

    /// <summary>Whether a strip is shown at a row.</summary>
    public bool IsShown(int link, int row, int strip) => ShownOn(link)[(row * CountOn(link)) + strip];

    /// <summary>Whether a picture at a station shows a strip at a row.</summary>
    public bool IsShownFrom(SurveyStation station, int link, int row, int strip)
    {
        RoadCurve curve = roads.Curves.Of(link);
        double along = roads.StationOf(link, row);
        double parameter = curve.ParameterAt(along);

        // The strip s of n lies between the offsets -w + 2 w s / n and -w + 2 w (s + 1) / n, as far as the carriageway reaches.
        double width = 2 * HalfWidth(link) / CountOn(link);
        (float left, float right) = roads.ReachAt(link, along);
        double from = Math.Min(right, Math.Max(left, MiddleOf(link, strip) - (width / 2)));
        double to = Math.Min(right, Math.Max(left, MiddleOf(link, strip) + (width / 2)));
        return station.Shows(curve.PointBeside(parameter, from), footprint) && station.Shows(curve.PointBeside(parameter, to), footprint);
    }

    /// <summary>Marks a strip at a row, for which a picture is taken.</summary>
    public void Mark(int link, int row, int strip) => ShownOn(link)[(row * CountOn(link)) + strip] = true;

    /// <summary>Marks all that a picture at a station shows.</summary>
    public void Mark(SurveyStation station)
    {
        double reach = footprint.HalfAlong + footprint.HalfAcross;
        foreach (int other in (IEnumerable<int>)roads.Near(station.Ground))
        {
            if (roads.Curves.Of(other).IsBeyond(new Vector2D(station.Ground.X, station.Ground.Y), reach))
            {
                continue;
            }

            bool[] shown = ShownOn(other);
            for (int i = 0; i < shown.Length; i++)
            {
                shown[i] = shown[i] || IsShownFrom(station, other, i / CountOn(other), i % CountOn(other));
            }
        }
    }

    private bool[] ShownOn(int link)
    {
        if (!_isShown.TryGetValue(link, out bool[]? shown))
        {
            int strips = CountOn(link);
            _isShown[link] = shown = new bool[roads.RowsOf(link) * strips];
            for (int i = 0; i < shown.Length; i++)
            {
                shown[i] = !IsWanted(link, i / strips);
            }
        }

        return shown;
    }

    /// <summary>How far a carriageway reaches to each side of its link's curve at most, metres.</summary>
    private double HalfWidth(int link)
    {
        RoadLink road = roads.Curves.Network.Links[link];
        double lanes = road.IsOneWay ? (road.LanesForward + road.LanesBackward) / 2.0 : Math.Max(road.LanesForward, road.LanesBackward);
        return (MaxLaneWidth * lanes) + ((road.MedianWidth ?? 0) / 2) + Shoulder;
    }
}
