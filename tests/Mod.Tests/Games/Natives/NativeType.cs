namespace Harvester.Mod.Tests.Games.Natives;

/// <summary>A type of the natives' signatures.</summary>
/// <param name="Name">As the table of natives writes it, such as BOOL, Hash or Vector3*.</param>
internal readonly record struct NativeType(string Name)
{
    public bool IsVoid => Name == "void";

    public bool IsBoolean => Name == "BOOL";

    public bool IsSingle => Name == "float";

    public bool IsVector => Name == "Vector3";

    public bool IsText => Name == "const char*";

    public bool IsAddress => Name.EndsWith('*') && !IsText;

    public bool IsAny => Name == "Any";

    /// <summary>What an address points to.</summary>
    public NativeType Pointee => new(Name[..^1]);

    public override string ToString() => Name;
}
