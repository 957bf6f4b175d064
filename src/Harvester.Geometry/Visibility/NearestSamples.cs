namespace Harvester.Geometry.Visibility;

/// <summary>Values known at samples of a silhouette, and those nearest to another sample.</summary>
/// <typeparam name="T">What is known of a sample.</typeparam>
/// <param name="box">The box around the silhouette; distances between samples are measured in its width and height.</param>
internal sealed class NearestSamples<T>(Box2D box)
{
    /// <summary>
    /// Number of neighbours that must agree. In simulated streets, 3 missed more of the small hidden or visible parts, and 5 needed 3 %
    /// more rays.
    /// </summary>
    public const int Count = 4;

    private readonly List<(double X, double Y, T Value)> _samples = [];
    private readonly (double Squared, int Index)[] _nearest = new (double, int)[Count];
    private readonly T[] _values = new T[Count];

    /// <summary>Adds a sample.</summary>
    public void Add(Vector2D pixel, T value)
    {
        (double x, double y) = Placed(pixel);
        _samples.Add((x, y, value));
    }

    /// <summary>The values of the nearest samples in the order of their distances, valid until the next call; null if fewer than <see
    /// cref="Count"/> are within a reach, in widths and heights of the box.</summary>
    public IReadOnlyList<T>? Near(Vector2D pixel, double reach)
    {
        if (_samples.Count < Count)
        {
            return null;
        }

        FindNearest(pixel);
        if (_nearest[Count - 1].Squared > reach * reach)
        {
            return null;
        }

        for (int i = 0; i < Count; i++)
        {
            _values[i] = _samples[_nearest[i].Index].Value;
        }

        return _values;
    }

    /// <summary>Whether the samples that <see cref="Near"/> found lie on both sides of the pixel, across and along the image.</summary>
    public bool Surround(Vector2D pixel)
    {
        (double x, double y) = Placed(pixel);
        return Array.Exists(_nearest, near => _samples[near.Index].X <= x)
            && Array.Exists(_nearest, near => _samples[near.Index].X >= x)
            && Array.Exists(_nearest, near => _samples[near.Index].Y <= y)
            && Array.Exists(_nearest, near => _samples[near.Index].Y >= y);
    }

    private (double X, double Y) Placed(Vector2D pixel) => ((pixel.X - box.XMin) / box.Width, (pixel.Y - box.YMin) / box.Height);

    private void FindNearest(Vector2D pixel)
    {
        (double x, double y) = Placed(pixel);
        int found = 0;
        for (int i = 0; i < _samples.Count; i++)
        {
            (double right, double down) = (_samples[i].X - x, _samples[i].Y - y);
            double squared = (right * right) + (down * down);
            int at = found < Count ? found++ : Count;
            while (at > 0 && squared < _nearest[at - 1].Squared)
            {
                at--;
                if (at < Count - 1)
                {
                    _nearest[at + 1] = _nearest[at];
                }
            }

            if (at < Count)
            {
                _nearest[at] = (squared, i);
            }
        }
    }
}
