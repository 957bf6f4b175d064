#if !NET5_0_OR_GREATER
namespace System.Runtime.CompilerServices;

/// <summary>Lets the compiler emit init accessors for frameworks that lack this marker.</summary>
internal static class IsExternalInit { }
#endif
