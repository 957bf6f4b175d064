using GTA.Native;

namespace Harvester.Mod.Tests.Games.Natives;

/// <summary>A call of a native as it is written in the mod, whether a play comes by it or not.</summary>
/// <param name="Place">The method that it is written in.</param>
/// <param name="Native">The native.</param>
/// <param name="Passed">What is passed, by position.</param>
/// <param name="Expected">The type that the result is read as; null when it is ignored.</param>
internal sealed record WrittenCall(string Place, Hash Native, IReadOnlyList<ArgumentKind> Passed, Type? Expected);
