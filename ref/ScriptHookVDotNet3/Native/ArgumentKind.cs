namespace GTA.Native;

/// <summary>What a script passed as an argument. The real API forgets it: a native sees eight bytes.</summary>
internal enum ArgumentKind
{
    /// <summary>A bool, as 0 or 1.</summary>
    Boolean,

    /// <summary>An int, sign-extended to eight bytes.</summary>
    Integer,

    /// <summary>A float in the lower four bytes.</summary>
    Single,

    /// <summary>The address of a string in UTF-8, or 0 for null.</summary>
    Text,

    /// <summary>An address to write to or to read from.</summary>
    Address,
}
