using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// Where an object is seen before its screen. A pixel is compared with the same pixel of the picture in which the object is hidden: if the
/// screen is seen there, the pixel is the object's unless at least half of it is the screen's; if something else is in front of the
/// screen, the pixel is the object's only if it changes, and not as in a shadow.
/// </summary>
internal sealed class ScreenMatte
{
    /// <summary>A screen of which fewer pixels are seen, or whose colour is weaker, is not trusted.</summary>
    private const int MinScreenPixels = 6;
    private const double MinStrength = 40;

    /// <summary>Pixels of the screen differ from its strongest ones by no more than this, in the same unit.</summary>
    private const double StrengthSpread = 30;

    /// <summary>A pixel that differs by more than this, grey levels, from the screen is not the screen's alone.</summary>
    private const double ScreenDifference = 24;

    private const double ScreenShareOfAll = 0.85;
    private const double MixedShare = 0.1;

    /// <summary>A pixel with a larger share of the screen does not tell the object's colour.</summary>
    private const double PureShare = 0.4;

    /// <summary>Pixels that differ by less than this, grey levels, are taken to show the same.</summary>
    private const double SameDifference = 14;

    /// <summary>A shadow leaves between this fraction of the light and all of it, and the colour to this fraction.</summary>
    private const double DarkestShadow = 0.12;
    private const double NoShadow = 1.02;
    private const double ShadowTint = 0.1;

    private readonly double _darkest;
    private readonly Func<int, int, bool> _isGround;
    private readonly Frame _frame;
    private readonly byte[]? _shown;
    private readonly byte[]? _empty;
    private readonly Vector3D _screen;
    private readonly double _strength;
    private readonly float[] _shares;

    /// <summary>Works out the pixels of an object.</summary>
    /// <param name="spans">The pixels of its screen.</param>
    /// <param name="width">Width of the image.</param>
    /// <param name="none">The picture without objects.</param>
    /// <param name="shown">The picture with the object before its screen, and the nearer screens in it.</param>
    /// <param name="empty">The picture with its screen only, and the nearer screens in it.</param>
    public ScreenMatte(
        SilhouetteSpans spans, int width, byte[] none, ScreenPicture? shown, ScreenPicture? empty, double darkest,
        Func<int, int, bool> isGround)
    {
        _darkest = darkest;
        _isGround = isGround;
        Left = spans.FirstColumn;
        Top = spans.FirstRow;
        Width = Math.Max(0, spans.LastColumn - spans.FirstColumn + 1);
        Height = Math.Max(0, spans.LastRow - spans.FirstRow + 2);
        State = new MatteState[Width * Height];
        _shares = new float[State.Length];
        _frame = new Frame(spans, width, none.Length / 3 / width);
        _shown = shown?.Bytes;
        _empty = empty?.Bytes;
        bool[] hasShown = Seen(shown);
        bool[] hasEmpty = Seen(empty);
        (_screen, _strength) = ScreenColour(hasShown, hasEmpty);
        IsTrusted = _strength >= MinStrength;
        if (IsTrusted)
        {
            Classify(none, hasShown, hasEmpty);
            SettleEdges();
            SettleEdges();
            SettleDoubts();
        }
    }

    public int Left { get; }

    public int Top { get; }

    public int Width { get; }

    public int Height { get; }

    /// <summary>Whether the screen is seen anywhere.</summary>
    public bool IsTrusted { get; }

    /// <summary>The states of its pixels, row by row.</summary>
    public MatteState[] State { get; }

    public MatteState StateAt(int column, int row)
    {
        (int x, int y) = (column - Left, row - Top);
        return x < 0 || y < 0 || x >= Width || y >= Height ? MatteState.Unknown : State[(y * Width) + x];
    }

    private bool[] Seen(ScreenPicture? picture)
    {
        var seen = new bool[State.Length];
        for (int index = 0; picture is not null && index < seen.Length; index++)
        {
            (int column, int row) = (Left + (index % Width), Top + (index / Width));
            seen[index] = row < _frame.Height && _frame.Contains(column, row) && !picture.IsHidden(column, row);
        }

        return seen;
    }

    private int PixelOf(int index) => ((Top + (index / Width)) * _frame.Width) + Left + (index % Width);

    private static Vector3D At(byte[] picture, int pixel) => new(picture[3 * pixel], picture[(3 * pixel) + 1], picture[(3 * pixel) + 2]);

    /// <summary>How much a colour is that of screens: 255 for theirs, 0 for grey.</summary>
    private static double StrengthOf(Vector3D colour) => ((colour.X + colour.Z) / 2) - colour.Y;

    private (Vector3D Colour, double Strength) ScreenColour(bool[] hasShown, bool[] hasEmpty)
    {
        List<Vector3D> colours = [];
        for (int index = 0; index < State.Length; index++)
        {
            int pixel = PixelOf(index);
            if (hasShown[index])
            {
                colours.Add(At(_shown!, pixel));
            }

            if (hasEmpty[index])
            {
                colours.Add(At(_empty!, pixel));
            }
        }

        colours.Sort(static (a, b) => StrengthOf(b).CompareTo(StrengthOf(a)));
        if (colours.Count < MinScreenPixels)
        {
            return (Vector3D.Zero, 0);
        }

        double strongest = StrengthOf(colours[Math.Min(MinScreenPixels, colours.Count / 20)]);
        (Vector3D sum, int count) = (Vector3D.Zero, 0);
        for (; count < colours.Count && StrengthOf(colours[count]) > strongest - StrengthSpread; count++)
        {
            sum += colours[count];
        }

        Vector3D mean = sum / Math.Max(1, count);
        return (mean, count >= MinScreenPixels ? StrengthOf(mean) : 0);
    }

    private void Classify(byte[] none, bool[] hasShown, bool[] hasEmpty)
    {
        for (int index = 0; index < State.Length; index++)
        {
            if (!hasShown[index])
            {
                continue;
            }

            int pixel = PixelOf(index);
            Vector3D shown = At(_shown!, pixel);
            if (hasEmpty[index])
            {
                Vector3D empty = At(_empty!, pixel);
                double changed = (shown - empty).Length;
                double share = ShareOf(empty, At(none, pixel));
                bool isGround = share < 0.5 && _isGround(Left + (index % Width), Top + (index / Width));
                State[index] = share < 0.5
                    ? IsSameWorld(shown, empty, Math.Max(0, share)) ? MatteState.World
                        : !IsShadow(shown, empty, isGround ? DarkestShadow : _darkest) ? MatteState.Object
                        : isGround ? MatteState.World : MatteState.Doubt
                    : changed > ScreenDifference && StrengthOf(shown) < ScreenShareOfAll * _strength ? MatteState.Object : MatteState.Screen;
            }
            else
            {
                State[index] = StrengthOf(shown) > ScreenShareOfAll * _strength ? MatteState.Screen
                    : (shown - At(none, pixel)).Length < SameDifference ? MatteState.World : MatteState.Object;
            }

            _shares[index] = (float)(StrengthOf(shown) / _strength);
        }
    }

    /// <summary>How much of a pixel is the screen's, if the rest is of another colour.</summary>
    private double ShareOf(Vector3D colour, Vector3D other)
    {
        Vector3D span = _screen - other;
        double squared = span.Dot(span);
        return squared < MinStrength * MinStrength ? 1 : (colour - other).Dot(span) / squared;
    }

    /// <summary>Whether only the screen's share of a pixel has changed.</summary>
    private bool IsSameWorld(Vector3D shown, Vector3D empty, double share)
    {
        if (share < 0.06)
        {
            return (shown - empty).Length < SameDifference;
        }

        Vector3D rest = shown - empty + (_screen * share);
        double least = -SameDifference;
        double most = (255 * share) + SameDifference;
        return rest.X > least && rest.Y > least && rest.Z > least && rest.X < most && rest.Y < most && rest.Z < most;
    }

    private static bool IsShadow(Vector3D shaded, Vector3D lit, double darkest)
    {
        double squared = lit.Dot(lit);
        double left = shaded.Dot(lit) / Math.Max(1, squared);
        return left > darkest && left < NoShadow
            && (shaded - (lit * left)).Length < (ShadowTint * Math.Sqrt(squared)) + SameDifference;
    }

    /// <summary>Whether a pixel shows the object alone, so that its colour is the object's.</summary>
    public bool IsPure(int column, int row)
    {
        (int x, int y) = (column - Left, row - Top);
        return StateOf(x, y) == MatteState.Object && _shares[(y * Width) + x] < MixedShare && !IsBesideScreen(x, y);
    }

    private MatteState StateOf(int x, int y) => x < 0 || y < 0 || x >= Width || y >= Height ? MatteState.Unknown : State[(y * Width) + x];

    private bool IsBesideScreen(int x, int y) => StateOf(x - 1, y) == MatteState.Screen || StateOf(x + 1, y) == MatteState.Screen
        || StateOf(x, y - 1) == MatteState.Screen || StateOf(x, y + 1) == MatteState.Screen;

    private bool IsInside(int x, int y) => StateOf(x - 1, y) == MatteState.Object && StateOf(x + 1, y) == MatteState.Object
        && StateOf(x, y - 1) == MatteState.Object && StateOf(x, y + 1) == MatteState.Object;

    /// <summary>
    /// A pixel before the rest of the world that changes as in a shadow is the object's if a pixel of the object beside it looks the same.
    /// </summary>
    private void SettleDoubts()
    {
        const int rounds = 12;
        for (int round = 0; round < rounds; round++)
        {
            List<int> grown = [];
            for (int y = 0; y < Height; y++)
            {
                for (int x = 0; x < Width; x++)
                {
                    int index = (y * Width) + x;
                    if (State[index] == MatteState.Doubt && IsLikeNeighbour(x, y))
                    {
                        grown.Add(index);
                    }
                }
            }

            foreach (int index in grown)
            {
                State[index] = MatteState.Object;
            }
        }

        for (int index = 0; index < State.Length; index++)
        {
            State[index] = State[index] == MatteState.Doubt ? MatteState.World : State[index];
        }
    }

    private bool IsLikeNeighbour(int x, int y)
    {
        int pixel = PixelOf((y * Width) + x);
        Vector3D colour = At(_shown!, pixel);
        double changed = (colour - At(_empty!, pixel)).Length;
        for (int v = y - 1; v <= y + 1; v++)
        {
            for (int u = x - 1; u <= x + 1; u++)
            {
                if (StateOf(u, v) == MatteState.Object
                    && (colour - At(_shown!, PixelOf((v * Width) + u))).Length < Math.Min(SameDifference + 4, changed / 2))
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>
    /// A pixel beside the screen may be a mixture of both. Half of it or more must be the object, whose colour is that of the nearest
    /// pixels that do not touch the screen, brighter or darker.
    /// </summary>
    private void SettleEdges()
    {
        List<int> trimmed = [];
        for (int y = 0; y < Height; y++)
        {
            for (int x = 0; x < Width; x++)
            {
                int index = (y * Width) + x;
                if (State[index] == MatteState.Object && !IsInside(x, y) && ScreenShare(x, y) > 0.505)
                {
                    trimmed.Add(index);
                }
            }
        }

        foreach (int index in trimmed)
        {
            State[index] = MatteState.Screen;
        }
    }

    internal double ScreenShare(int x, int y)
    {
        int index = (y * Width) + x;
        Vector3D colour = At(_shown!, PixelOf(index));
        double share = _shares[index];
        double best = double.PositiveInfinity;
        const int reach = 2;
        for (int v = y - reach; v <= y + reach; v++)
        {
            for (int u = x - reach; u <= x + reach; u++)
            {
                if ((u == x && v == y) || StateOf(u, v) != MatteState.Object)
                {
                    continue;
                }

                int other = (v * Width) + u;
                bool isPure = !IsBesideScreen(u, v);
                if (_shares[other] > PureShare || (!isPure && _shares[other] > _shares[index]))
                {
                    continue;
                }

                (double part, double left) = Mixture(colour, At(_shown!, PixelOf(other)));
                double cost = left + (isPure ? 0 : 40) + (4 * (((u - x) * (u - x)) + ((v - y) * (v - y))));
                if (cost < best)
                {
                    (best, share) = (cost, part);
                }
            }
        }

        return share;
    }

    /// <summary>Explains a colour by the screen's and another, which may be brighter or darker: the screen's share, and what is left.</summary>
    private (double Share, double Left) Mixture(Vector3D colour, Vector3D other)
    {
        // Least squares for colour = a·other + t·screen, with a weak wish that a + t is 1.
        const double wish = 5;
        double oo = other.Dot(other) + (wish * wish);
        double os = other.Dot(_screen) + (wish * wish);
        double ss = _screen.Dot(_screen) + (wish * wish);
        double co = colour.Dot(other) + (wish * wish);
        double cs = colour.Dot(_screen) + (wish * wish);
        double determinant = Math.Max(1, (oo * ss) - (os * os));
        double a = Math.Max(0, ((co * ss) - (cs * os)) / determinant);
        double t = Math.Max(0, Math.Min(1, ((cs * oo) - (co * os)) / determinant));
        return (t, (colour - (other * a) - (_screen * t)).Length);
    }

    private sealed record Frame(SilhouetteSpans Spans, int Width, int Height)
    {
        public bool Contains(int column, int row) => (Spans.Contains(column, row) && Spans.Contains(Math.Max(0, column - 1), row)
            && Spans.Contains(Math.Min(Width - 1, column + 1), row) && Spans.Contains(column, Math.Max(0, row - 1)))
            || (!Spans.Contains(column, row) && Spans.Contains(column, row - 1) && Spans.Contains(column - 1, row - 1)
                && Spans.Contains(column + 1, row - 1));
    }
}
