using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.ClassMaps;

/// <summary>The classes of an image as far as they are given, sampled or drawn. Each pixel is sampled once.</summary>
internal sealed class ClassSamples
{
    private readonly Func<int, int, byte> _sample;
    private readonly byte[] _drawn;
    private readonly State[] _states;
    private readonly int _budget;

    public ClassSamples(ImageSize image, byte[] given, Func<int, int, byte> sample, int budget)
    {
        Image = image;
        _sample = sample;
        _budget = budget;
        _drawn = (byte[])given.Clone();
        _states = Array.ConvertAll(given, value => value == 0 ? State.Open : State.Given);
    }

    private enum State : byte
    {
        Open,
        Given,
        Sampled,
    }

    public ImageSize Image { get; }

    public int RaysCast { get; private set; }

    /// <summary>Whether no ray is left.</summary>
    public bool IsSpent => RaysCast >= _budget;

    /// <summary>Pixels whose sample differs from what had been drawn there.</summary>
    public List<(int Column, int Row)> Surprises { get; } = [];

    /// <summary>What is drawn at a pixel; 0 for nothing yet.</summary>
    public byte this[int column, int row] => _drawn[Index(column, row)];

    public bool IsGiven(int column, int row) => _states[Index(column, row)] == State.Given;

    public bool IsSampled(int column, int row) => _states[Index(column, row)] == State.Sampled;

    /// <summary>The class at a pixel: by a ray if it is neither given nor known. Without a ray left, it is what is drawn there.</summary>
    public byte At(int column, int row)
    {
        int index = Index(column, row);
        if (_states[index] == State.Open && !IsSpent)
        {
            byte found = _sample(column, row);
            if (_drawn[index] != 0 && _drawn[index] != found)
            {
                Surprises.Add((column, row));
            }

            RaysCast++;
            _drawn[index] = found;
            _states[index] = State.Sampled;
        }

        return _drawn[index];
    }

    /// <summary>Draws a pixel, unless its class is given or sampled.</summary>
    /// <returns>Whether the pixel has that class now, or shows something given.</returns>
    public bool Draw(int column, int row, byte value)
    {
        int index = Index(column, row);
        if (_states[index] == State.Open)
        {
            _drawn[index] = value;
        }

        return _states[index] != State.Sampled || _drawn[index] == value;
    }

    /// <summary>Number of pixels that are neither given nor sampled.</summary>
    public int CountOpen()
    {
        int open = 0;
        foreach (State state in _states)
        {
            open += state == State.Open ? 1 : 0;
        }

        return open;
    }

    private int Index(int column, int row) => (row * Image.Width) + column;
}
