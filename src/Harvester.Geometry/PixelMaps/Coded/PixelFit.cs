namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// Explains the values of a pixel by a stack of objects, the nearest first, before a background: each picture shows the first of them that
/// is not hidden. Among the stacks, the one with the lowest cost is chosen: the squared deviations within the groups of pictures that show
/// the same, in units of the noise, and a price for each object and each shadow.
/// </summary>
internal sealed class PixelFit
{
    /// <summary>Maximum number of objects of a stack; more are not separated by as many pictures as there are.</summary>
    public const int MaxLayers = 3;

    /// <summary>
    /// The price of an object by the Bayesian information criterion, in units of -2 ln(likelihood), as all costs are: its three colour
    /// values cost 3 ln n = 8.3 for n = 16 pictures; the other 5.7 pay for the choice among e^(5.7 / 2) = 17 candidates.
    /// </summary>
    private const double LayerPrice = 14;

    /// <summary>
    /// The price of a shadow. More objects may cast it than may be in the pixel, so it costs 4 more than an object: the choice among
    /// e^(4 / 2) = 7 times as many.
    /// </summary>
    private const double ShadowPrice = 18;

    /// <summary>The price of a farther object in front of a nearer one: it decides between objects of the same colour.</summary>
    private const double ReversePrice = 4;

    /// <summary>
    /// Mean squared deviation that the best stack may leave, in units of the noise; if it is larger, the noise is taken to be. For 16
    /// pictures it is a mean of up to 45 squared deviations, with a standard deviation of √(2 / 45) = 0.21: this is 3.8 of them over 1.
    /// </summary>
    private const double MaxExcess = 1.8;

    /// <summary>Standard deviation that light reflected between objects may add, as a fraction of the value.</summary>
    private const double LightFraction = 0.01;

    /// <summary>
    /// A shadow leaves between this fraction of the light and all of it, apart from noise. Both limits are wide: <see
    /// cref="ShadowSeparator"/> decides by the shadows of the frame.
    /// </summary>
    private const double DarkestShadow = 0.12;
    private const double NoShadow = 1.02;

    /// <summary>Number of objects that are tried in each place of a stack.</summary>
    private const int Tried = 3;

    /// <summary>Maximum number of candidates of a pixel that are scored; the rest are left out.</summary>
    private const int MaxScored = 64;

    /// <summary>A group is even if its cost exceeds the expected one by no more than this many standard deviations.</summary>
    private const double EvenDeviations = 3;

    private readonly PictureStack _stack;
    private readonly uint[] _shown;
    private readonly double[] _distances;
    private readonly Stack[] _levels = new Stack[MaxLayers + 1];
    private readonly double[] _scores = new double[MaxLayers * MaxScored];
    private List<int> _candidates = [];
    private List<int> _casters = [];
    private double _variance;

    public PixelFit(PictureStack stack, uint[] shown, double[] distances)
    {
        _stack = stack;
        _shown = shown;
        _distances = distances;
        for (int i = 0; i < _levels.Length; i++)
        {
            _levels[i] = new Stack();
        }
    }

    /// <summary>The best stack of the latest pixel.</summary>
    public Stack Best => _levels[0];

    /// <summary>How much more the best stack with another front costs.</summary>
    public double Margin { get; private set; }

    /// <summary>Explains the loaded pixel.</summary>
    /// <param name="variance">Its noise.</param>
    /// <param name="candidates">The objects that may be there.</param>
    /// <param name="casters">The objects that may cast a shadow on it.</param>
    public void Fit(double variance, List<int> candidates, List<int> casters)
    {
        (_candidates, _casters) = (candidates, casters);

        // Reflected light adds the variance (f·v)² to each channel's value v. Averaged over the three channels that is f²·|mean colour|² /
        // 3.
        double brightness = _stack.MeanIn(_stack.All).Length * LightFraction;
        _variance = variance + (brightness * brightness / 3);
        Margin = double.PositiveInfinity;

        // What remains without the prices of the objects is a sum of squared deviations, apart from the rarer prices of shadows and order.
        // The n pictures have 3n values, and a stack of k objects has fitted a mean colour to each of its k + 1 groups: 3(n - 1 - k)
        // degrees of freedom.
        double rest = FitLevel(0, _stack.All) - (LayerPrice * Best.Count);
        double excess = rest / (3 * (_stack.Count - 1 - Best.Count));
        if (Best.Count > 0 && excess > MaxExcess)
        {
            // Something else changes, such as a moving texture: a stack must explain more than that.
            // Costs shrink by this factor while prices stay, so an object is worth its price only if it explains excess times as much.
            _variance *= excess;
            Margin = double.PositiveInfinity;
            FitLevel(0, _stack.All);
        }
    }

    /// <summary>Whether the loaded pixel shows one surface that an object shades.</summary>
    /// <param name="variance">Its noise.</param>
    /// <param name="casters">The objects that may cast a shadow on it.</param>
    /// <returns>Its colours in the shadow and out of it; null if it shows none.</returns>
    public (Vector3D Shaded, Vector3D Lit)? FindShadow(double variance, List<int> casters)
    {
        _casters = casters;
        _variance = variance;

        // Without candidates a pixel is one surface; GroupCost splits off the shaded pictures if that is cheaper than an uneven group.
        GroupCost(_stack.All, out uint seen);
        return seen == _stack.All ? null : (_stack.MeanIn(seen), _stack.MeanIn(_stack.All & ~seen));
    }

    /// <summary>Whether the pictures of a group show the same, apart from noise.</summary>
    private static bool IsEven(double cost, uint group)
    {
        // For noise alone the cost of n pictures is chi-squared with d = 3(n - 1) degrees of freedom: mean d, variance 2d.
        double expected = 3 * (PictureStack.CountOf(group) - 1);
        return cost < expected + (EvenDeviations * Math.Sqrt(2 * Math.Max(1, expected)));
    }

    private double FitLevel(int level, uint group)
    {
        Stack best = _levels[level];

        // The alternative to any further object: what these pictures show is the background. It is final at the last layer, where no object
        // may be, and where the pictures are equal apart from noise.
        double cost = GroupCost(group, out uint seen);
        best.Count = 0;
        best.Groups[0] = seen;
        if (level == MaxLayers || _candidates.Count == 0 || IsEven(_stack.SquaresIn(group) / _variance, group))
        {
            return cost;
        }

        Span(level, group, out int first, out int count);
        for (int i = 0; i < count; i++)
        {
            int candidate = Cheapest(first);
            if (candidate < 0)
            {
                break;
            }

            // Pictures that show the candidate show it in front of the rest; the others are explained by the next level.
            uint front = group & _shown[candidate];
            double frontCost = GroupCost(front, out uint frontSeen) + LayerPrice;

            // The level behind costs 0 or more. At the front, a worse candidate is still followed, because Margin compares fronts.
            if (level > 0 && frontCost >= cost)
            {
                continue;
            }

            double total = frontCost + FitLevel(level + 1, group & ~front);
            Stack behind = _levels[level + 1];

            // The nearer object is usually in front, so the opposite order needs evidence of its own.
            total += behind.Count > 0 && _distances[behind.Objects[0]] < _distances[candidate] ? ReversePrice : 0;
            if (total < cost)
            {
                if (level == 0)
                {
                    // The previous best becomes the second best. The first one is the background alone.
                    Margin = cost - total;
                }

                cost = total;
                best.Take(candidate, frontSeen, _levels[level + 1]);
            }
            else if (level == 0)
            {
                Margin = Math.Min(Margin, total - cost);
            }
        }

        return cost;
    }

    /// <summary>Scores the candidates by the deviations that remain if one of them is in front, and nothing else behind it.</summary>
    private void Span(int level, uint group, out int first, out int count)
    {
        first = level * MaxScored;
        int number = Math.Min(MaxScored, _candidates.Count);
        for (int i = 0; i < MaxScored; i++)
        {
            _scores[first + i] = double.PositiveInfinity;
        }

        for (int i = 0; i < number; i++)
        {
            uint front = group & _shown[_candidates[i]];

            // An object that all or none of the group's pictures show explains no change in it.
            if (front != 0 && front != group)
            {
                _scores[first + i] = _stack.SquaresIn(front) + _stack.SquaresIn(group & ~front);
            }
        }

        count = Math.Min(Tried, number);
    }

    private int Cheapest(int first)
    {
        int best = -1;
        for (int i = 0; i < Math.Min(MaxScored, _candidates.Count); i++)
        {
            if (!double.IsPositiveInfinity(_scores[first + i]) && (best < 0 || _scores[first + i] < _scores[first + best]))
            {
                best = i;
            }
        }

        if (best < 0)
        {
            return -1;
        }

        _scores[first + best] = double.PositiveInfinity;
        return _candidates[best];
    }

    /// <summary>The cost of pictures that show one surface, perhaps shaded in some of them.</summary>
    private double GroupCost(uint group, out uint seen)
    {
        seen = group;
        double cost = _stack.SquaresIn(group) / _variance;
        if (IsEven(cost, group))
        {
            return cost;
        }

        foreach (int caster in _casters)
        {
            uint shaded = group & _shown[caster];
            if (shaded == 0 || shaded == group)
            {
                continue;
            }

            // One surface, shaded by the caster where it is shown: two mean colours instead of one, whose ratio must be that of a shadow.
            double split = ((_stack.SquaresIn(shaded) + _stack.SquaresIn(group & ~shaded)) / _variance) + ShadowPrice;
            if (split < cost && IsShadow(_stack.MeanIn(shaded), _stack.MeanIn(group & ~shaded)))
            {
                (cost, seen) = (split, shaded);
            }
        }

        return cost;
    }

    private bool IsShadow(Vector3D shaded, Vector3D lit)
    {
        double noise = Math.Sqrt(_variance);
        return IsShadow(shaded.X, lit.X, noise) && IsShadow(shaded.Y, lit.Y, noise) && IsShadow(shaded.Z, lit.Z, noise);
    }

    // DarkestShadow · lit < shaded < NoShadow · lit, with a standard deviation of the noise on either side.
    private static bool IsShadow(double shaded, double lit, double noise) =>
        shaded < (NoShadow * lit) + noise && shaded > (DarkestShadow * lit) - noise;

    /// <summary>Objects one behind another, and the pictures that show each; the last group shows the background.</summary>
    internal sealed class Stack
    {
        public int Count { get; set; }

        public int[] Objects { get; } = new int[MaxLayers + 1];

        public uint[] Groups { get; } = new uint[MaxLayers + 2];

        public void Take(int front, uint group, Stack behind)
        {
            Count = Math.Min(MaxLayers, behind.Count + 1);
            Objects[0] = front;
            Groups[0] = group;
            Array.Copy(behind.Objects, 0, Objects, 1, behind.Count);
            Array.Copy(behind.Groups, 0, Groups, 1, behind.Count + 1);
        }
    }
}
