using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>
/// Worn paint: in cells along a stripe, paint is gone with probability w / 2, and otherwise faded towards the asphalt by up to w. What is
/// worn depends on the seed and the cell's place alone.
/// </summary>
internal sealed class PaintWear(int seed, double wear)
{
    /// <summary>Length of a cell, metres.</summary>
    private const double Cell = 0.25;

    private const double MaxGone = 0.5;

    /// <summary>The parts of a stripe that are left, with their colours.</summary>
    /// <param name="stripe">What tells the stripe from others.</param>
    /// <param name="from">Where it begins, metres along its road.</param>
    /// <param name="to">Where it ends.</param>
    /// <param name="colour">The colour of new paint.</param>
    public IEnumerable<(double From, double To, Rgb Colour)> Left(int stripe, double from, double to, Rgb colour)
    {
        if (wear == 0)
        {
            yield return (from, to, colour);
            yield break;
        }

        int last = (int)Math.Ceiling(to / Cell);
        for (int cell = (int)Math.Floor(from / Cell); cell < last; cell++)
        {
            var random = new Random(unchecked((((seed * 31) + stripe) * 8191) + cell));
            bool isGone = random.NextDouble() < MaxGone * wear;
            double faded = wear * random.NextDouble();
            if (!isGone)
            {
                yield return (Math.Max(from, cell * Cell), Math.Min(to, (cell + 1) * Cell), colour.Towards(Palette.Asphalt, faded));
            }
        }
    }
}
