#if !NET7_0_OR_GREATER
namespace System.Runtime.CompilerServices;

/// <summary>Lets the compiler emit required members for frameworks that lack this marker.</summary>
[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct | AttributeTargets.Field | AttributeTargets.Property, Inherited = false)]
internal sealed class RequiredMemberAttribute : Attribute { }
#endif
