#if !NET7_0_OR_GREATER
namespace System.Runtime.CompilerServices;

/// <summary>Marks members whose use needs a compiler feature, for frameworks that lack this marker.</summary>
[AttributeUsage(AttributeTargets.All, AllowMultiple = true, Inherited = false)]
internal sealed class CompilerFeatureRequiredAttribute(string featureName) : Attribute
{
    public string FeatureName { get; } = featureName;
}
#endif
