using GTA.Math;
using GTA.Native;

namespace Harvester.Mod.Tests.Games.Natives;

/// <summary>What a native takes and returns.</summary>
internal sealed record NativeSignature(string Name, ulong Hash, NativeType Result, IReadOnlyList<NativeType> Parameters)
{
    /// <summary>What is wrong with a call: too few or too many arguments, or types that the native reads otherwise.</summary>
    /// <param name="passed">What was passed, by position.</param>
    /// <param name="expected">The type that the result is read as; null when it is ignored.</param>
    public IEnumerable<string> MistakesIn(IReadOnlyList<ArgumentKind> passed, Type? expected)
    {
        if (passed.Count != Parameters.Count)
        {
            yield return $"{Name} takes {Parameters.Count} arguments and got {passed.Count}.";
        }

        for (int i = 0; i < Math.Min(Parameters.Count, passed.Count); i++)
        {
            if (!Takes(Parameters[i], passed[i]))
            {
                yield return $"{Name} takes {Parameters[i]} as argument {i} and got {passed[i]}.";
            }
        }

        if (expected is not null && !Returns(expected))
        {
            yield return $"{Name} returns {Result} and was read as {expected.Name}.";
        }
    }

    private static bool Takes(NativeType parameter, ArgumentKind passed) =>
        parameter.IsAny
        || passed
            == (
                parameter.IsBoolean ? ArgumentKind.Boolean
                : parameter.IsSingle ? ArgumentKind.Single
                : parameter.IsText ? ArgumentKind.Text
                : parameter.IsAddress ? ArgumentKind.Address
                : ArgumentKind.Integer
            );

    private bool Returns(Type expected) =>
        !Result.IsVoid
        && expected
            == (
                Result.IsBoolean ? typeof(bool)
                : Result.IsSingle ? typeof(float)
                : Result.IsVector ? typeof(Vector3)
                : Result.IsText ? typeof(string)
                : typeof(int)
            );
}
