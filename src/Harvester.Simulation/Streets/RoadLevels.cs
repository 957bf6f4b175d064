using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>Where roads cross above others, where they stand on the ground, and where they share the ground with others.</summary>
internal sealed class RoadLevels
{
    /// <summary>Distance between samples along a road, metres.</summary>
    public const double Step = 4;

    /// <summary>Minimum height above another road for a bridge over it, metres; nearer roads meet.</summary>
    private const double OtherLevel = 2.5;

    /// <summary>Ground beside the lower road's asphalt that a bridge spans too, metres.</summary>
    private const double Verge = 1;

    /// <summary>Distance from a crossing at which the abutment of a bridge stands, metres.</summary>
    private const double ToAbutment = 6;

    /// <summary>Crossings that follow each other within this distance are spanned by one viaduct, metres.</summary>
    private const double LongestFill = 90;

    private readonly Dictionary<Road, double[]> _rooms = [];
    private readonly Dictionary<Road, bool[]> _isShared = [];
    private readonly Dictionary<Road, bool[]> _isSuspended = [];

    public RoadLevels(IReadOnlyList<Road> roads, StreetIndex index)
    {
        foreach (Road road in roads)
        {
            int samples = CountSamples(road);
            double[] rooms = new double[samples];
            bool[] isShared = new bool[samples];
            for (int i = 0; i < samples; i++)
            {
                (rooms[i], isShared[i]) = Feel(road, DistanceOf(road, i), index);
            }

            _rooms[road] = rooms;
            _isShared[road] = isShared;
            _isSuspended[road] = Suspended(road, rooms);
        }
    }

    /// <summary>Number of samples along a road.</summary>
    public static int CountSamples(Road road) => Math.Max(1, (int)Math.Ceiling(road.Length / Step)) + 1;

    /// <summary>Position of a sample, metres along the road.</summary>
    public static double DistanceOf(Road road, int sample) => road.Length * sample / (CountSamples(road) - 1);

    /// <summary>Whether the road is on a bridge at a sample, so that the ground below does not follow it.</summary>
    public bool IsSuspended(Road road, int sample) => _isSuspended[road][sample];

    /// <summary>Whether the road is on a bridge at a distance along it, metres.</summary>
    public bool IsSuspended(Road road, double distance) =>
        _isSuspended[road][(int)Math.Round(distance / road.Length * (CountSamples(road) - 1))];

    /// <summary>Whether another road's asphalt is on or beside the road's, on one level, near a stretch of it, metres along it.</summary>
    public bool IsShared(Road road, double from, double to)
    {
        bool[] isShared = _isShared[road];
        double scale = (isShared.Length - 1) / road.Length;
        int last = Math.Min(isShared.Length - 1, (int)Math.Ceiling(to * scale) + 1);
        for (int i = Math.Max(0, (int)(from * scale) - 1); i <= last; i++)
        {
            if (isShared[i])
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Height above the highest road below, metres, near a distance along a road; infinite without one.</summary>
    public double RoomBelow(Road road, double distance)
    {
        double[] rooms = _rooms[road];
        int nearest = (int)Math.Round(distance / road.Length * (rooms.Length - 1));
        return rooms[Math.Max(0, nearest - 1)..Math.Min(rooms.Length, nearest + 2)].Min();
    }

    private static (double Room, bool IsShared) Feel(Road road, double distance, StreetIndex index)
    {
        CrossSection section = road.Curve.SectionAt(distance);
        double room = double.PositiveInfinity;
        bool isShared = false;
        const int across = 4;
        double beside = road.IsStreet ? Walkway.Width : 0;
        for (int i = 0; i <= across; i++)
        {
            Vector3D place = section.At(road.LeftKerb - beside + ((road.RightKerb - road.LeftKerb + (2 * beside)) * i / across));
            if (index.IsAlone(road, place))
            {
                continue;
            }

            foreach (RoadPlace other in index.PlacesAt(place, Step, except: road, beside: Road.WidestShoulder + Verge))
            {
                if (other.IsOnCarriageway(other.Road.Shoulder + Verge))
                {
                    room = other.Height > OtherLevel ? Math.Min(room, other.Height) : room;
                    isShared |= Math.Abs(other.Height) < OtherLevel;
                }
            }
        }

        return (room, isShared);
    }

    private static bool[] Suspended(Road road, double[] rooms)
    {
        bool[] isSuspended = new bool[rooms.Length];
        double step = road.Length / (rooms.Length - 1);
        int reach = (int)Math.Ceiling(ToAbutment / step);
        int fill = (int)(LongestFill / step);
        int last = -1;
        for (int i = 0; i < rooms.Length; i++)
        {
            if (double.IsPositiveInfinity(rooms[i]))
            {
                continue;
            }

            int from = last >= 0 && i - last <= fill ? last : i - reach;
            for (int j = Math.Max(0, from); j <= Math.Min(rooms.Length - 1, i + reach); j++)
            {
                isSuspended[j] = true;
            }

            last = i;
        }

        return isSuspended;
    }
}
