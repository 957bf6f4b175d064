using GTA.Native;

namespace GTA;

/// <summary>A model by its hash.</summary>
public struct Model : INativeValue
{
    /// <summary>Names a model by its hash.</summary>
    public Model(int hash) => Hash = hash;

    /// <summary>The hash of the model's name.</summary>
    public int Hash { get; private set; }

    /// <summary>The hash, sign-extended.</summary>
    public ulong NativeValue
    {
        readonly get => (ulong)Hash;
        set => Hash = unchecked((int)value);
    }
}
