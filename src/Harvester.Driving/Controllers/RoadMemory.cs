using System;
using System.Collections.Generic;

namespace Harvester.Driving.Controllers;

/// <summary>
/// Where the road leads between the car and its look-ahead point, put together from the angles seen there while the car drove on. From
/// it come the angle at the car and the bends ahead, which a single frame does not tell apart. Lengths are metres along the road,
/// headings radians in a frame of the memory's own, positive to the left.
/// </summary>
/// <param name="lookAheadMetres">How far ahead the angles are measured; 0 or more.</param>
internal sealed class RoadMemory(double lookAheadMetres)
{
    /// <summary>Frames nearer to each other than this count as one place: a standing car sees it again and again.</summary>
    private const double SamePlace = 0.4;

    /// <summary>Places within this distance of one that is asked for are weighed in; they even out the noise of single frames.</summary>
    private const double Reach = 4;

    /// <summary>Added to the spread of the places, m²: few of them tell no bend.</summary>
    private const double SpreadOfNone = 2;

    private const double SeedStep = 1;

    private readonly double _lookAheadMetres = lookAheadMetres >= 0
        ? lookAheadMetres
        : throw new ArgumentOutOfRangeException(nameof(lookAheadMetres), lookAheadMetres, "Angles are measured at the car or ahead of it.");

    private readonly List<(double Station, double Heading, int Frames)> _seen = [];
    private double _station;
    private double _heading;

    /// <summary>The car has driven so far and turned by so much to the left.</summary>
    public void Advance(double metres, double turned)
    {
        _station += metres;
        _heading += turned;
        _seen.RemoveAll(place => place.Station < _station - Reach);
    }

    /// <summary>The road's heading at the look-ahead point less the car's.</summary>
    public void See(double angle)
    {
        double station = _station + _lookAheadMetres;
        double heading = _heading + angle;
        if (_seen.Count == 0)
        {
            // Nothing is known of the way to there. Who hands a car over hands it over along its road: an arc that begins in its direction.
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
                Heading = ((place.Heading * place.Frames) + heading) / (place.Frames + 1),
                Frames = place.Frames + 1
            };
        }
        else
        {
            _seen.Add((station, heading, 1));
        }
    }

    /// <summary>Forgets everything, as where the road is lost from sight.</summary>
    public void Forget() => _seen.Clear();

    /// <summary>The road's heading some way ahead less the car's, and how it bends there, 1/m.</summary>
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
