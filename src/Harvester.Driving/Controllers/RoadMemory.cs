namespace Harvester.Driving.Controllers;

/// <summary>
/// The course of the road between the car and its look-ahead point, assembled from the angles measured there while the car drove. It gives
/// the angle at the car and the bends ahead, which a single frame cannot separate. Lengths are metres along the road; headings are radians
/// in a frame of its own, positive to the left.
/// </summary>
/// <param name="lookAheadMetres">Distance ahead at which the angles are measured; 0 or more.</param>
internal sealed class RoadMemory(double lookAheadMetres)
{
    /// <summary>Frames closer together than this count as one position: a standing car measures it repeatedly.</summary>
    private const double SamePlace = 0.4;

    /// <summary>Positions within this distance are averaged to reduce the noise of single frames.</summary>
    private const double Reach = 4;

    /// <summary>Added to the variance of the positions, m²: too few of them show no bend.</summary>
    private const double SpreadOfNone = 2;

    /// <summary>Distance between the positions of the assumed road at the start, metres.</summary>
    private const double SeedStep = 1;

    private readonly double _lookAheadMetres =
        lookAheadMetres >= 0
            ? lookAheadMetres
            : throw new ArgumentOutOfRangeException(
                nameof(lookAheadMetres),
                lookAheadMetres,
                "Angles are measured at the car or ahead of it."
            );

    private readonly List<(double Station, double Heading, int Frames)> _seen = [];
    private double _station;
    private double _heading;

    /// <summary>Moves the car along the road: the distance driven and the angle turned, positive to the left.</summary>
    public void Advance(double metres, double turned)
    {
        _station += metres;
        _heading += turned;
        _seen.RemoveAll(place => place.Station < _station - Reach);
    }

    /// <summary>Adds the road's heading at the look-ahead point minus the car's.</summary>
    public void See(double angle)
    {
        double station = _station + _lookAheadMetres;
        double heading = _heading + angle;
        if (_seen.Count == 0)
        {
            // The road up to there is unknown. Assume that the drive begins along the road: an arc that begins in the car's direction.
            for (double share = 0; share < 1; share += SeedStep / _lookAheadMetres)
            {
                _seen.Add((_station + (share * _lookAheadMetres), _heading + (share * angle), 1));
            }
        }

        int last = _seen.Count - 1;
        if (last >= 0 && station - _seen[last].Station < SamePlace)
        {
            (double Station, double Heading, int Frames) place = _seen[last];
            _seen[last] = place with
            {
                // Running mean over the frames at this position.
                Heading = ((place.Heading * place.Frames) + heading) / (place.Frames + 1),
                Frames = place.Frames + 1,
            };
        }
        else
        {
            _seen.Add((station, heading, 1));
        }
    }

    /// <summary>Discards everything, as when the road is lost.</summary>
    public void Clear() => _seen.Clear();

    /// <summary>The road's heading at a distance ahead minus the car's, and the curvature there, 1/m.</summary>
    public (double Angle, double Curvature) At(double metresAhead)
    {
        double station = _station + metresAhead;
        double count = 0;
        double meanStation = 0;
        double meanHeading = 0;
        foreach ((double place, double heading, _) in _seen)
        {
            if (Math.Abs(place - station) <= Reach)
            {
                count++;
                meanStation += place;
                meanHeading += heading;
            }
        }

        if (count == 0)
        {
            return (_seen.Count > 0 ? Nearest(station) - _heading : 0, 0);
        }

        meanStation /= count;
        meanHeading /= count;

        // Regression of the heading over the station: its slope is the curvature, Σ(s - s̄)(h - h̄) / Σ(s - s̄)², drawn towards 0 by the
        // constant in the denominator.
        double spread = SpreadOfNone;
        double common = 0;
        foreach ((double place, double heading, _) in _seen)
        {
            if (Math.Abs(place - station) <= Reach)
            {
                spread += (place - meanStation) * (place - meanStation);
                common += (place - meanStation) * (heading - meanHeading);
            }
        }

        double curvature = common / spread;
        return (meanHeading + (curvature * (station - meanStation)) - _heading, curvature);
    }

    private double Nearest(double station)
    {
        double nearest = double.PositiveInfinity;
        double found = 0;
        foreach ((double place, double heading, _) in _seen)
        {
            if (Math.Abs(place - station) < nearest)
            {
                nearest = Math.Abs(place - station);
                found = heading;
            }
        }

        return found;
    }
}
