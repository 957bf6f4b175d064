using System;
using System.Collections.Generic;
using System.Linq;

namespace Harvester.Surveys.Faces;

/// <summary>
/// Finds how far a shape reaches in a direction: rays go on from the places that are known to lie on it, and where it reaches furthest,
/// more closely beside each other, so that tips between the known places are found, too.
/// </summary>
/// <param name="isOn">Whether the shape is at a place, given across the direction and along it, metres.</param>
/// <param name="step">Distance between the known places, metres.</param>
/// <param name="sign">1 towards larger numbers along the direction, -1 towards smaller ones.</param>
internal sealed class EdgeSearch(Func<double, double, bool> isOn, double step, int sign)
{
    /// <summary>A place is ignored if it extends the edge by less than this, metres.</summary>
    private const double MinGain = 0.001;

    /// <summary>Halvings of the step along the direction; and, at the tip, across it.</summary>
    private const int Halvings = 4;

    /// <summary>One in so many of the known places is tried.</summary>
    private const int Stride = 2;

    /// <summary>Steps after which a shape is taken to have no end.</summary>
    private const int MaxSteps = 1000;

    private double _across;

    /// <summary>Where the shape ends, metres along the direction.</summary>
    public double Furthest { get; private set; }

    /// <summary>Searches; each element is a few rays.</summary>
    /// <param name="known">Places on the shape, across the direction and along it, metres; at least one.</param>
    public IEnumerable<bool> Run(IEnumerable<(double Across, double Along)> known)
    {
        (double Across, double Along)[] places = [.. known];
        (_across, Furthest) = places.OrderByDescending(place => sign * place.Along).First();
        Follow();
        foreach (double across in places.Select(place => place.Across).Distinct().OrderBy(across => across)
            .Where((_, i) => i % Stride == 0))
        {
            Try(across);
            yield return true;
        }

        double beside = Stride * step;
        for (int i = 0; i < Halvings + Stride; i++)
        {
            while (Try(_across - beside) || Try(_across + beside))
            {
                yield return true;
            }

            yield return true;
            beside /= 2;
        }
    }

    /// <summary>Goes on at a place across the direction, if the shape reaches further there.</summary>
    private bool Try(double across)
    {
        double further = Furthest + (sign * MinGain);
        if (!isOn(across, further))
        {
            return false;
        }

        (_across, Furthest) = (across, further);
        Follow();
        return true;
    }

    /// <summary>From a place on the shape to its end.</summary>
    private void Follow()
    {
        int steps = 0;
        while (steps++ < MaxSteps && isOn(_across, Furthest + (sign * step)))
        {
            Furthest += sign * step;
        }

        double part = step;
        for (int i = 0; i < Halvings; i++)
        {
            part /= 2;
            Furthest += isOn(_across, Furthest + (sign * part)) ? sign * part : 0;
        }
    }
}
