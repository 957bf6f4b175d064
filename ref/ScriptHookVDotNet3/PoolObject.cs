using GTA.Native;

namespace GTA;

/// <summary>Something in one of the game's pools.</summary>
public abstract class PoolObject : INativeValue
{
    private protected PoolObject(int handle) => Handle = handle;

    /// <summary>The game's handle.</summary>
    public int Handle { get; private set; }

    /// <summary>The handle, sign-extended.</summary>
    public ulong NativeValue
    {
        get => (ulong)Handle;
        set => Handle = unchecked((int)value);
    }
}
