namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// Decides what pixels show in which the rest of the world is in front of the screen and changes as in a shadow, or not at all: the object
/// if it looks the same beside them.
/// </summary>
internal sealed class MatteDoubts(ScreenMatte matte, ScreenView view)
{
    /// <summary>Each round reaches a pixel farther: the object grows into doubt, then into small gaps.</summary>
    private const int GrowingRounds = 12;
    private const int FillingRounds = 2;

    /// <summary>
    /// A pixel in doubt looks the same as one of the object if it differs by less than this, grey levels, and than this part of its change.
    /// </summary>
    private const double LikeLevels = 18;
    private const double LikeChange = 0.5;

    /// <summary>A pixel with this many neighbours of the object looks like it if it differs less from one of them, grey levels.</summary>
    private const int Surrounding = 5;
    private const double SurroundedLevels = 25;

    public void Settle()
    {
        for (int round = 0; round < GrowingRounds; round++)
        {
            Change(MatteState.Doubt, IsLikeNeighbour);
        }

        for (int index = 0; index < matte.State.Length; index++)
        {
            matte.State[index] = matte.State[index] == MatteState.Doubt ? MatteState.World : matte.State[index];
        }

        for (int round = 0; round < FillingRounds; round++)
        {
            Change(MatteState.World, IsSurrounded);
        }
    }

    private void Change(MatteState from, Func<int, int, bool> isObject)
    {
        List<int> changed = [];
        for (int y = 0; y < matte.Height; y++)
        {
            for (int x = 0; x < matte.Width; x++)
            {
                if (matte.At(x, y) == from && isObject(x, y))
                {
                    changed.Add((y * matte.Width) + x);
                }
            }
        }

        changed.ForEach(index => matte.State[index] = MatteState.Object);
    }

    private bool IsLikeNeighbour(int x, int y)
    {
        int index = (y * matte.Width) + x;

        // Where the object changes little, a colour like a neighbour's proves little, so the difference must also be less than half of the
        // change.
        double change = (view.Shown(index) - view.Empty(index)).Length;
        return Compared(x, y).Least < Math.Min(LikeLevels, LikeChange * change);
    }

    private bool IsSurrounded(int x, int y)
    {
        (int count, double least) = Compared(x, y);
        return count >= Surrounding && least < SurroundedLevels;
    }

    /// <summary>The number of pixels of the object around one, and the least difference from them, grey levels.</summary>
    private (int Count, double Least) Compared(int x, int y)
    {
        Vector3D colour = view.Shown((y * matte.Width) + x);
        (int count, double least) = (0, double.PositiveInfinity);
        for (int v = y - 1; v <= y + 1; v++)
        {
            for (int u = x - 1; u <= x + 1; u++)
            {
                if (matte.At(u, v) == MatteState.Object)
                {
                    least = Math.Min(least, (colour - view.Shown((v * matte.Width) + u)).Length);
                    count++;
                }
            }
        }

        return (count, least);
    }
}
