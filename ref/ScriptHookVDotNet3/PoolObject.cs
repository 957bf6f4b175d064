namespace GTA;

/// <summary>Something in one of the game's pools.</summary>
public abstract class PoolObject
{
    private protected PoolObject(int handle) => Handle = handle;

    /// <summary>The game's handle.</summary>
    public int Handle { get; }
}
