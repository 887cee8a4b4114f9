import random
random.seed(1)
d,k,terms=34,6500,34
B=64
with open('big.mat','w') as f:
    f.write(f"matrices 2 {d}\n")
    for t in range(2):
        for i in range(d): f.write("row "+" ".join(f"{random.randint(-2**30,2**30)}/{31*2**28}" for _ in range(d))+"\n")
word=[random.randint(0,1) for _ in range(20)]
with open('big.cert','w') as f:
    f.write(f"subcert-certificate 3\nradius 2 {d}\nbounds - 1000000000\n")
    f.write(f"product 0 100 0 {' '.join(map(str,word))}\n")
    f.write(f"block 0 polytope {k} {B} {B}\n")
    for i in range(k):
        v=[random.randint(-2**B,2**B) for _ in range(d)] if i>=d else [2**B*(i==j) for j in range(d)]
        f.write("vertex "+" ".join(map(str,v))+"\n")
    for i in range(d): f.write(f"unit {i} {i}:{2**B}\n")
    for j in range(k):
        for t in range(2):
            f.write(f"image {j} {t} "+" ".join(f"{random.randrange(k)}:{random.randint(-2**59,2**59)}" for _ in range(terms))+"\n")
    f.write("end\n")
